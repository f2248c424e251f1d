#include <common/CompleteFile.h>

#include <TemporaryFolder.h>

#include <filesystem>
#include <fstream>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

class CompleteFile : public test::TemporaryFolderTest
{
};

std::string writeHalf(const std::string& name)
{
    std::ofstream(name) << "half";
    return "the disk is full, says " + name;
}

TEST_F(CompleteFile, ExistsOnceItIsComplete)
{
    const std::string name = pathOf("a.txt");
    EXPECT_EQ(writeCompleteFile(name,
                                [](const std::string& temporary)
                                {
                                    EXPECT_EQ(fs::path(temporary).extension(), ".txt");
                                    std::ofstream(temporary) << "whole";
                                    return std::string();
                                }),
              "");
    std::string text;
    std::ifstream(name) >> text;
    EXPECT_EQ(text, "whole");
    EXPECT_EQ(countFiles(), 1u);
}

TEST_F(CompleteFile, KeepsTheOldFileWhenWritingFails)
{
    const std::string name = pathOf("a.txt");
    std::ofstream(name) << "old";
    EXPECT_EQ(writeCompleteFile(name, writeHalf), "the disk is full, says " + name);
    std::string text;
    std::ifstream(name) >> text;
    EXPECT_EQ(text, "old");
    EXPECT_EQ(countFiles(), 1u);
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
