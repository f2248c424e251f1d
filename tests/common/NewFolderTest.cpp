#include <common/NewFolder.h>

#include <TemporaryFolder.h>

#include <filesystem>
#include <fstream>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

class NewFolderTest : public test::TemporaryFolderTest
{
};

TEST_F(NewFolderTest, RemainsIfItIsKeptOrHasFiles)
{
    const std::string path = pathOf("new");
    {
        NewFolder folder(path);
        EXPECT_FALSE(folder.getError());
        EXPECT_TRUE(fs::is_directory(path));
    }
    EXPECT_FALSE(fs::exists(path));
    {
        NewFolder folder(path);
        folder.keep();
    }
    EXPECT_TRUE(fs::is_directory(path));
    fs::remove(path);
    {
        NewFolder folder(path);
        std::ofstream(path + "/file") << "content";
    }
    EXPECT_TRUE(fs::exists(path + "/file"));
}

TEST_F(NewFolderTest, ExistingFoldersRemain)
{
    const std::string path = pathOf("old");
    fs::create_directory(path);
    {
        NewFolder folder(path);
        EXPECT_FALSE(folder.getError());
    }
    EXPECT_TRUE(fs::is_directory(path));
    NewFolder current("");
    EXPECT_FALSE(current.getError());
}

TEST_F(NewFolderTest, AFolderInNoFolderIsAnError)
{
    NewFolder folder(pathOf("no/new"));
    EXPECT_TRUE(folder.getError());
}

} // namespace

} // namespace osgLego
