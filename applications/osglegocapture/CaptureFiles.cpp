#include "CaptureFiles.h"

#include "ExitCode.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace osgLego
{

namespace
{

CaptureError cannotWrite(const std::string& fileName, const std::string& why)
{
    return {EXIT_BAD_OUTPUT, "can't write '" + fileName + "': " + why};
}

} // namespace

void checkPlace(const std::string& fileName)
{
    if (fileName.empty()) return;
    if (const std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty())
        throw cannotWrite(fileName, obstacle);
}

void checkPicturePlace(const std::string& fileName)
{
    checkPlace(fileName);
    if (fileName.empty() || OIIO::ImageOutput::create(fileName)) return;
    OIIO::geterror(); // or it stays for the next to ask
    throw cannotWrite(fileName, "its extension is that of no picture; allowed: .png, .tif, .exr and what else "
                                "OpenImageIO writes");
}

void checkAreDistinct(const std::vector<std::string>& fileNames)
{
    for (auto fileName = fileNames.begin(); fileName != fileNames.end(); ++fileName)
        for (auto other = fileNames.begin(); other != fileName; ++other)
            if (!fileName->empty() && !other->empty() && isSameFile(*fileName, *other))
                throw cannotWrite(*fileName, "two outputs have this name; allowed: a file each");
}

void writeText(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    const std::string why = writeCompleteFile(fileName,
                                              [&](const std::string& temporaryName)
                                              {
                                                  std::ofstream file(temporaryName, std::ios::binary);
                                                  if (file) write(file);
                                                  file.close();
                                                  return file ? std::string() : std::string(std::strerror(errno));
                                              });
    if (!why.empty()) throw cannotWrite(fileName, why);
}

void writePicture(const std::string& fileName, const OIIO::ImageBuf& picture)
{
    const std::string why =
        writeCompleteFile(fileName, [&](const std::string& temporaryName)
                          { return picture.write(temporaryName) ? std::string() : picture.geterror(); });
    if (!why.empty()) throw cannotWrite(fileName, why);
}

OIIO::ImageBuf toImageBuf(const osg::Image& image)
{
    const OIIO::ImageSpec spec(image.s(), image.t(), 3, OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf upsideDown(spec);
    upsideDown.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, image.data(), OIIO::AutoStride,
                          static_cast<OIIO::stride_t>(image.getRowStepInBytes()));
    return OIIO::ImageBufAlgo::flip(upsideDown);
}

void writeCells(const std::string& fileName, const BrickModel& model)
{
    writeText(fileName,
              [&](std::ostream& stream)
              {
                  stream << "x,y,z,red,green,blue\n";
                  for (const Brick& brick : model.getBricks())
                      stream << fmt::format("{},{},{},{},{},{}\n", brick.cell[0], brick.cell[1], brick.cell[2],
                                            brick.color[0], brick.color[1], brick.color[2]);
              });
}

} // namespace osgLego
