#include <common/ReadableFile.h>

#include <TemporaryFolder.h>

#include <fstream>

namespace osgLego::test
{

namespace
{

using ReadableFile = TemporaryFolderTest;

TEST_F(ReadableFile, AFileIsReadable)
{
    std::ofstream(pathOf("file")) << "text";
    EXPECT_EQ(findObstacleToReading(pathOf("file")), "");
}

TEST_F(ReadableFile, AMissingFileAndAFolderAreObstacles)
{
    EXPECT_EQ(findObstacleToReading(pathOf("none")), "there is no such file");
    EXPECT_EQ(findObstacleToReading(pathOf(".")), "it is a folder; expected a file");
    std::ofstream(pathOf("file")) << "text";
    EXPECT_EQ(findObstacleToReading(pathOf("file/below")), "Not a directory");
}

} // namespace

} // namespace osgLego::test
