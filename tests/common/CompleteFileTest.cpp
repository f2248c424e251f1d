#include <common/CompleteFile.h>

#include <TemporaryFolder.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>

#include <sys/resource.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

class CompleteFile : public test::TemporaryFolderTest
{
protected:
    /** Write a file as any program does. @return its path. */
    std::string writeUsual(const std::string& name) const
    {
        std::ofstream(pathOf(name)) << "old";
        return pathOf(name);
    }
};

std::string writeHalf(std::ostream& stream)
{
    stream << "half";
    return "the model has no end";
}

std::string writeWhole(std::ostream& stream)
{
    stream << "whole";
    return {};
}

TEST_F(CompleteFile, ExistsOnceItIsComplete)
{
    const std::string name = pathOf("a.txt");
    EXPECT_EQ(writeCompleteFile(name,
                                [&](std::ostream& stream)
                                {
                                    stream << "who" << std::flush;
                                    EXPECT_FALSE(fs::exists(name));
                                    stream << "le";
                                    return std::string();
                                }),
              "");
    EXPECT_EQ(contentsOf(name), "whole");
    EXPECT_EQ(countFiles(), 1u);
    EXPECT_EQ(fs::status(name).permissions() & fs::perms::mask, fs::status(writeUsual("b.txt")).permissions());
}

TEST_F(CompleteFile, HasEachByteOfALargeText)
{
    const std::string name = pathOf("a.txt");
    std::string text;
    for (int number = 0; text.size() < 1000000; ++number)
        text += std::to_string(number);
    EXPECT_EQ(writeCompleteFile(name,
                                [&](std::ostream& stream)
                                {
                                    stream << text.substr(0, 70000) << text[70000] << text.substr(70001);
                                    return std::string();
                                }),
              "");
    EXPECT_TRUE(contentsOf(name) == text);
}

TEST_F(CompleteFile, OfTwoWritersAtOnceIsTheWholeFileOfTheOneThatEndsLast)
{
    const std::string name = pathOf("a.txt");
    const auto writeBetween = [&](std::ostream& stream)
    {
        stream << "fir" << std::flush;
        EXPECT_EQ(writeCompleteFile(name, writeWhole), "");
        EXPECT_EQ(contentsOf(name), "whole");
        stream << "st";
        return std::string();
    };
    EXPECT_EQ(writeCompleteFile(name, writeBetween), "");
    EXPECT_EQ(contentsOf(name), "first");
    EXPECT_EQ(countFiles(), 1u);
}

TEST_F(CompleteFile, KeepsTheOldFileWhenWritingFails)
{
    const std::string name = pathOf("a.txt");
    std::ofstream(name) << "old";
    EXPECT_EQ(writeCompleteFile(name, writeHalf), "the model has no end");
    const auto writeAndThrow = [](std::ostream& stream) -> std::string
    {
        stream << "half";
        throw std::bad_alloc();
    };
    EXPECT_THROW(writeCompleteFile(name, writeAndThrow), std::bad_alloc);
    EXPECT_EQ(contentsOf(name), "old");
    EXPECT_EQ(countFiles(), 1u);
}

TEST_F(CompleteFile, KeepsTheOldFileIfTheStreamFailsForAnotherReasonThanTheDisk)
{
    const std::string name = pathOf("a.txt");
    std::ofstream(name) << "old";
    const auto fail = [](std::ostream& stream)
    {
        stream << "half";
        stream.setstate(std::ios::badbit);
        return std::string();
    };
    EXPECT_EQ(writeCompleteFile(name, fail), "its content can't be written");
    EXPECT_EQ(contentsOf(name), "old");
}

TEST_F(CompleteFile, KeepsTheOldFileWhenNoMoreFits)
{
    const std::string name = pathOf("a.txt");
    std::ofstream(name) << "old";
    // As on a full disk, writing first stops early, and then fails.
    rlimit former{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &former), 0);
    const rlimit limit{100000, former.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const std::string why = writeCompleteFile(name,
                                              [](std::ostream& stream)
                                              {
                                                  for (int line = 0; line < 100000; ++line)
                                                      stream << "longer\n";
                                                  return std::string();
                                              });
    setrlimit(RLIMIT_FSIZE, &former);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(why, "File too large");
    EXPECT_EQ(contentsOf(name), "old");
    EXPECT_EQ(countFiles(), 1u);
}

TEST_F(CompleteFile, KeepsThePermissionsOfTheOldFile)
{
    const std::string name = writeUsual("a.txt");
    for (const fs::perms permissions : {fs::perms(0600), fs::perms(0640), fs::perms(0755)})
    {
        fs::permissions(name, permissions);
        EXPECT_EQ(writeCompleteFile(name, writeWhole), "");
        EXPECT_EQ(fs::status(name).permissions(), permissions);
    }
    EXPECT_EQ(contentsOf(name), "whole");
}

TEST_F(CompleteFile, MayHaveTheLongestName)
{
    const std::string name = pathOf(std::string(251, 'a') + ".txt");
    EXPECT_EQ(writeCompleteFile(name, writeWhole), "");
    EXPECT_EQ(writeCompleteFile(name, writeWhole), "");
    EXPECT_EQ(contentsOf(name), "whole");
}

TEST_F(CompleteFile, ANameThatIsTooLongIsRefusedBeforehand)
{
    EXPECT_EQ(findObstacleToWriting(pathOf(std::string(256, 'a'))), "File name too long; expected another name");
}

TEST_F(CompleteFile, IsWrittenThroughALink)
{
    const std::string name = writeUsual("a.txt");
    fs::create_symlink("a.txt", pathOf("link"));
    EXPECT_EQ(writeCompleteFile(pathOf("link"), writeWhole), "");
    EXPECT_TRUE(fs::is_symlink(pathOf("link")));
    EXPECT_EQ(contentsOf(name), "whole");
}

TEST_F(CompleteFile, IsWrittenThroughLinksToAFileThatDoesNotExist)
{
    fs::create_directory(pathOf("folder"));
    fs::create_symlink("folder/second", pathOf("first"));
    fs::create_symlink("new.txt", pathOf("folder/second"));
    EXPECT_TRUE(isSameFile(pathOf("first"), pathOf("folder/new.txt")));
    EXPECT_EQ(writeCompleteFile(pathOf("first"), writeWhole), "");
    EXPECT_TRUE(fs::is_symlink(pathOf("first")));
    EXPECT_EQ(contentsOf(pathOf("folder/new.txt")), "whole");
    fs::create_symlink("nowhere/a.txt", pathOf("lost"));
    EXPECT_EQ(writeCompleteFile(pathOf("lost"), writeWhole),
              "there is no folder '" + pathOf("nowhere") + "'; expected an existing one");
    EXPECT_TRUE(fs::is_symlink(pathOf("lost")));
}

TEST_F(CompleteFile, IsNotWrittenThroughLinksThatReferToEachOther)
{
    fs::create_symlink("b", pathOf("a"));
    fs::create_symlink("a", pathOf("b"));
    EXPECT_EQ(writeCompleteFile(pathOf("a"), writeWhole), "its symbolic links refer to each other; expected a file");
    EXPECT_TRUE(fs::is_symlink(pathOf("a")));
}

TEST_F(CompleteFile, DevicesSayThatTheyAreFull)
{
    EXPECT_EQ(writeCompleteFile("/dev/full", writeWhole), "No space left on device");
    EXPECT_EQ(writeCompleteFile("/dev/null", writeWhole), "");
}

TEST_F(CompleteFile, NamesTheProblemWithItsFolder)
{
    EXPECT_EQ(writeCompleteFile(_folder.string(), writeHalf), "it is a folder; expected a file");
    EXPECT_EQ(writeCompleteFile(pathOf("none/a.txt"), writeHalf),
              "there is no folder '" + pathOf("none") + "'; expected an existing one");
    std::ofstream(pathOf("file")) << "text";
    EXPECT_EQ(writeCompleteFile(pathOf("file/a.txt"), writeHalf),
              "'" + pathOf("file") + "' is a file; expected a folder");
    EXPECT_EQ(countFiles(), 1u);
}

} // namespace

} // namespace osgLego
