#include <ldraw/LDrawParser.h>
#include <ldraw/LDrawResolver.h>

#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A document whose submodels include each other twice, with a part in the last one. */
LDrawDocument createDoubling(int levels)
{
    const std::string place = "1 4 0 0 0 1 0 0 0 1 0 0 0 1 ";
    std::string text = "0 FILE 0.ldr\n";
    for (int level = 1; level <= levels; ++level)
    {
        const std::string line = place + std::to_string(level) + ".ldr\n";
        text += line + line + "0 FILE " + std::to_string(level) + ".ldr\n";
    }
    std::string error;
    std::optional<LDrawDocument> document = LDrawParser::parse(text + place + "3005.dat\n", error);
    EXPECT_TRUE(document) << error;
    return *document;
}

TEST(LDrawResolver, TooManyLinesAreRefusedBeforeTheirPartsTakeMemory)
{
    LDrawLibrary library("", "");
    const LDrawDocument document = createDoubling(60);
    LDrawResolver resolver(document, library);
    EXPECT_EQ(resolver.resolve(), "its submodels add up to more than 10000000 lines; expected fewer");
    EXPECT_TRUE(resolver.getParts().empty());
}

TEST(LDrawResolver, SubmodelsMayMultiplyWithinTheLimit)
{
    LDrawLibrary library("", "");
    const LDrawDocument document = createDoubling(10);
    LDrawResolver resolver(document, library);
    EXPECT_EQ(resolver.resolve(), "");
    EXPECT_EQ(resolver.getParts().size(), 1024u);
}

} // namespace

} // namespace osgLego
