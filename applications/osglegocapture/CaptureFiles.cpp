#include "CaptureFiles.h"

#include "Cancellation.h"
#include "ExitCode.h"

#include <common/CompleteFile.h>
#include <common/PictureBuffer.h>
#include <common/PictureFile.h>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

const char* const OPENEXR = "openexr";

/** The format in which OpenImageIO writes a file with this name; empty if there is none. */
std::string formatOf(const std::string& fileName)
{
    const auto output = OIIO::ImageOutput::create(fileName);
    if (output) return output->format_name();
    OIIO::geterror(); // clear the error, or the next call would get it
    return {};
}

bool isWantedList(const std::string& fileName)
{
    return osgDB::getLowerCaseFileExtension(fileName) == "xml";
}

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

void checkPicturePlace(const std::string& fileName, bool isTransparent)
{
    checkPlace(fileName);
    if (fileName.empty()) return;
    const std::string format = formatOf(fileName);
    if (format.empty())
        throw cannotWrite(fileName, "its extension is not that of a picture; expected .png, .tif, .exr or another that "
                                    "OpenImageIO supports");
    if (isTransparent && format != "png" && format != "tiff" && format != OPENEXR)
        throw cannotWrite(fileName, "its format can't store a transparent background; expected .png, .tif or .exr");
}

void checkPartsListPlace(const std::string& fileName)
{
    checkPlace(fileName);
    if (!fileName.empty() && !isWantedList(fileName) && osgDB::getLowerCaseFileExtension(fileName) != "csv")
        throw cannotWrite(fileName, "its extension is not that of a parts list; expected .csv or .xml");
}

void checkAreDistinct(const std::vector<std::string>& fileNames)
{
    for (auto fileName = fileNames.begin(); fileName != fileNames.end(); ++fileName)
        for (auto other = fileNames.begin(); other != fileName; ++other)
            if (!fileName->empty() && !other->empty() && isSameFile(*fileName, *other))
                throw cannotWrite(*fileName, "two outputs have this name; expected different files");
}

void writeText(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    const std::string why = writeCompleteFile(fileName,
                                              [&](std::ostream& stream)
                                              {
                                                  write(stream);
                                                  Cancellation::check("cancelled while '" + fileName + "' was written");
                                                  return std::string();
                                              });
    if (!why.empty()) throw cannotWrite(fileName, why);
}

void writePicture(const std::string& fileName, const OIIO::ImageBuf& picture)
{
    const OIIO::ImageBuf written = formatOf(fileName) == OPENEXR ? toMultiplied(picture) : picture;
    if (const std::string why = writePictureFile(fileName, written); !why.empty()) throw cannotWrite(fileName, why);
}

void writePartsList(const std::string& fileName, const PartsList& list)
{
    writeText(fileName,
              [&](std::ostream& stream)
              {
                  if (isWantedList(fileName))
                      list.writeWantedList(stream);
                  else
                      list.writeCsv(stream);
              });
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
