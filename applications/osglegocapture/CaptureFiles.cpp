#include "CaptureFiles.h"

#include "ExitCode.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

CaptureError cannotWrite(const std::string& fileName, const std::string& why)
{
    return {EXIT_BAD_OUTPUT, "can't write '" + fileName + "': " + why};
}

/** Beside the file, with its extension, since that is what the format is told by. */
std::string temporaryNameOf(const std::string& fileName)
{
    const fs::path path(fileName);
    fs::path name = path.stem();
    name += fmt::format(".{}.part", static_cast<long>(getpid()));
    name += path.extension();
    return (path.parent_path() / name).string();
}

} // namespace

void writeComplete(const std::string& fileName, const std::function<void(const std::string&)>& write)
{
    const std::string temporaryName = temporaryNameOf(fileName);
    std::error_code ignored;
    try
    {
        if (fs::is_directory(fileName, ignored)) throw cannotWrite(fileName, "it is a folder");
        const fs::path folder = fs::path(fileName).parent_path();
        if (!folder.empty() && !fs::is_directory(folder, ignored))
            throw cannotWrite(fileName, "there is no folder '" + folder.string() + "'");
        write(temporaryName);
        std::error_code error;
        fs::rename(temporaryName, fileName, error);
        if (error) throw cannotWrite(fileName, error.message());
    }
    catch (...)
    {
        fs::remove(temporaryName, ignored);
        throw;
    }
}

void writeText(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    writeComplete(fileName,
                  [&](const std::string& temporaryName)
                  {
                      std::ofstream file(temporaryName, std::ios::binary);
                      if (file) write(file);
                      file.close();
                      if (!file) throw cannotWrite(fileName, std::strerror(errno));
                  });
}

void writePicture(const std::string& fileName, const OIIO::ImageBuf& picture)
{
    writeComplete(fileName,
                  [&](const std::string& temporaryName)
                  {
                      if (picture.write(temporaryName)) return;
                      // OpenImageIO speaks of the name that it was given.
                      std::string why = picture.geterror();
                      if (const auto place = why.find(temporaryName); place != std::string::npos)
                          why.replace(place, temporaryName.size(), fileName);
                      throw cannotWrite(fileName, why);
                  });
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
