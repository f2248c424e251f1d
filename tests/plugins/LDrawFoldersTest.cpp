#include <ldraw/LDrawFolders.h>

#include <TemporaryFolder.h>

namespace osgLego::test
{

namespace
{

/** Finds files in the test's folder. */
class LDrawFoldersTest : public TemporaryFolderTest
{
protected:
    void write(const std::string& name)
    {
        std::filesystem::create_directories((_folder / name).parent_path());
        std::ofstream(_folder / name) << "0";
    }

    std::string find(const std::string& name) { return _folders.findFile(_folder.string(), name); }

    LDrawFolders _folders;
};

TEST_F(LDrawFoldersTest, FilesAreFoundInAnyCaseInFoldersOfAnyCase)
{
    write("Sub/Inner/My Tower.LDR");
    EXPECT_EQ(find("sub/inner/my tower.ldr"), pathOf("Sub/Inner/My Tower.LDR"));
    EXPECT_EQ(find("SUB/./inner/MY TOWER.ldr"), pathOf("Sub/Inner/My Tower.LDR"));
    EXPECT_EQ(find("sub/inner/tower.ldr"), "");
    EXPECT_EQ(find("sub/inner"), "") << "a folder is not a file";
}

TEST_F(LDrawFoldersTest, TheExactNameIsPreferred)
{
    write("A.ldr");
    write("a.ldr");
    write("a.LDR");
    EXPECT_EQ(find("a.ldr"), pathOf("a.ldr"));
    EXPECT_EQ(find("a.LDR"), pathOf("a.LDR"));
    EXPECT_EQ(find("A.LDR"), pathOf("A.ldr")) << "the first in the order of their bytes";
}

TEST_F(LDrawFoldersTest, AFolderIsListedOnce)
{
    EXPECT_EQ(find("a.ldr"), "");
    write("A.ldr");
    EXPECT_EQ(find("a.ldr"), "") << "the folder was listed again";
    EXPECT_EQ(find("A.ldr"), pathOf("A.ldr")) << "exact names need no list";
}

TEST_F(LDrawFoldersTest, FilesOutsideTheFolderAreNotFound)
{
    write("secret.ldr");
    write("sub/a.ldr");
    LDrawFolders folders;
    EXPECT_EQ(folders.findFile(pathOf("sub"), "../secret.ldr"), "");
    EXPECT_EQ(folders.findFile(pathOf("sub"), "x/../../secret.ldr"), "");
    EXPECT_EQ(folders.findFile(pathOf("sub"), pathOf("secret.ldr")), "");
    EXPECT_EQ(folders.findFile(pathOf("sub"), ""), "");
}

TEST_F(LDrawFoldersTest, FoldersThatDoNotExistContainNothing)
{
    EXPECT_EQ(find("none/a.ldr"), "");
    EXPECT_EQ(_folders.findEntry(pathOf("none"), "parts"), "");
}

} // namespace

} // namespace osgLego::test
