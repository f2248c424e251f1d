#include <common/MarkupText.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(MarkupText, EscapesAllThatHtmlReads)
{
    EXPECT_EQ(escapedForMarkup("<a href=\"x\">&</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;&lt;/a&gt;");
}

} // namespace

} // namespace osgLego
