#include <osgLego/gl/ShaderLibrary.h>

#include <Notices.h>
#include <TemporaryFolder.h>

#include <cstdlib>

namespace osgLego::test
{

namespace
{

/** Shaders in a folder of their own. */
class ShaderFolder : public TemporaryFolderTest
{
protected:
    void SetUp() override
    {
        TemporaryFolderTest::SetUp();
        setenv("OSGLEGO_SHADER_PATH", _folder.c_str(), 1);
    }

    void TearDown() override
    {
        unsetenv("OSGLEGO_SHADER_PATH");
        TemporaryFolderTest::TearDown();
    }

    void write(const std::string& name, const std::string& text) { std::ofstream(pathOf(name)) << text; }
};

TEST_F(ShaderFolder, IncludesAreReplacedByTheirFilesAsOftenAsTheyAreIncluded)
{
    write("outer.frag", "#include \"inner.glsl\"\nmiddle\n#include \"inner.glsl\"\n");
    write("inner.glsl", "#include \"deep.glsl\"\ninner\n");
    write("deep.glsl", "deep\n");
    EXPECT_EQ(ShaderLibrary::getSource("outer.frag"), "deep\ninner\nmiddle\ndeep\ninner\n");
}

TEST_F(ShaderFolder, AFileThatIncludesItselfIsNamedOnceWithAllOnItsWay)
{
    write("first.frag", "#include \"second.glsl\"\n");
    write("second.glsl", "text\n#include \"third.glsl\"\n#include \"third.glsl\"\n");
    write("third.glsl", "#include \"second.glsl\"\n");
    write("alone.frag", "#include \"alone.frag\"\n");
    std::string source = "text";
    const auto readTwice = [&]
    {
        ShaderLibrary::getSource("first.frag");
        source = ShaderLibrary::getSource("first.frag");
    };
    EXPECT_EQ(noticesOf(readTwice),
              "osgLego: 'second.glsl' includes 'third.glsl' includes 'second.glsl'; expected shaders "
              "that do not include themselves\n");
    EXPECT_EQ(source, "");
    EXPECT_EQ(noticesOf([] { ShaderLibrary::getSource("alone.frag"); }),
              "osgLego: 'alone.frag' includes 'alone.frag'; expected shaders that do not include themselves\n");
}

TEST_F(ShaderFolder, AMissingFileIsNamedOnce)
{
    write("incomplete.frag", "#include \"missing.glsl\"\nrest\n");
    std::string source;
    const auto readTwice = [&]
    {
        ShaderLibrary::getSource("incomplete.frag");
        source = ShaderLibrary::getSource("incomplete.frag");
    };
    EXPECT_EQ(noticesOf(readTwice), "osgLego: shader 'missing.glsl' not found\n");
    EXPECT_EQ(source, "rest\n");
}

} // namespace

} // namespace osgLego::test
