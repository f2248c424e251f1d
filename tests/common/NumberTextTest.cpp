#include <common/NumberText.h>

#include <gtest/gtest.h>

namespace osgLego
{

TEST(NumberTextTest, GroupsDigitsAndFormsPlurals)
{
    EXPECT_EQ(countOf(1, "part"), "1 part");
    EXPECT_EQ(countOf(999, "part"), "999 parts");
    EXPECT_EQ(countOf(20000, "part"), "20,000 parts");
    EXPECT_EQ(formatNumber(1234567), "1,234,567");
}

} // namespace osgLego
