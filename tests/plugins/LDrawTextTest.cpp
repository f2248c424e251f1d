#include <ldraw/LDrawText.h>

#include <TemporaryFolder.h>

#include <sys/stat.h>

namespace osgLego::test
{

namespace
{

using LDrawText = TemporaryFolderTest;

std::string errorOf(const std::string& path)
{
    std::string error;
    EXPECT_FALSE(readText(path, error));
    return error;
}

TEST_F(LDrawText, FilesAreReadWhole)
{
    std::string content(200'000, 'x'); // several blocks
    content[150'000] = '\0';
    std::ofstream(pathOf("a.ldr"), std::ios::binary) << content;
    std::string error;
    EXPECT_EQ(readText(pathOf("a.ldr"), error), content) << error;
}

TEST_F(LDrawText, PipesAndDevicesAreRefusedRatherThanReadWithoutEnd)
{
    ASSERT_EQ(mkfifo(pathOf("a.ldr").c_str(), 0600), 0);
    EXPECT_EQ(errorOf(pathOf("a.ldr")), "it is a device or a pipe; expected a regular file");
    EXPECT_EQ(errorOf("/dev/zero"), "it is a device or a pipe; expected a regular file");
}

TEST_F(LDrawText, FilesThatAreTooLargeAreRefused)
{
    std::ofstream(pathOf("a.ldr")) << "0";
    std::filesystem::resize_file(pathOf("a.ldr"), LARGEST_TEXT + 1); // takes no blocks of the disk
    EXPECT_EQ(errorOf(pathOf("a.ldr")), "it has 1073741825 bytes; expected at most 1073741824");
}

TEST_F(LDrawText, StreamsAreReadUpToTheirLimit)
{
    std::string error;
    std::istringstream fits("0123456789");
    EXPECT_EQ(readText(fits, error, 10), "0123456789") << error;
    std::istringstream isLonger("0123456789A");
    EXPECT_FALSE(readText(isLonger, error, 10));
    EXPECT_EQ(error, "it has more than 10 bytes; expected fewer");
}

TEST_F(LDrawText, StreamsThatFailAreAnError)
{
    std::istringstream stream("0123456789");
    stream.setstate(std::ios::badbit);
    std::string error;
    EXPECT_FALSE(readText(stream, error));
    EXPECT_EQ(error, "its content can't be read");
}

} // namespace

} // namespace osgLego::test
