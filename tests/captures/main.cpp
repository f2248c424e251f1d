#include "References.h"
#include "SceneFile.h"
#include "SceneLibrary.h"

#include <common/PictureBuffer.h>
#include <offscreen/OffscreenContext.h>
#include <osglegocapture/CaptureFiles.h>
#include <osglegocapture/CaptureScene.h>
#include <osglegocapture/ExitCode.h>
#include <osglegocapture/ScenePicture.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace osgLego::test
{

namespace
{

const char* const USAGE =
    R"(Draws the scenes of a file, all or those named in the order of the names, into NAME.png each; or compares pictures with references.
Usage: regression-captures SCENES_FILE OUTPUT_FOLDER [NAME...]
       regression-captures --compare REFERENCE_FOLDER OUTPUT_FOLDER HTML_FILE
)";

std::unique_ptr<CaptureScene> createScene(const SceneLine& line, const CaptureOptions& options)
{
    if (line.mesh.front() != '@') return std::make_unique<CaptureScene>(options);
    const osg::ref_ptr<osg::Node> node = createLibraryScene(line.mesh.substr(1));
    if (!node) throw CaptureError(EXIT_BAD_INPUT, "there is no scene '" + line.mesh + "'");
    return std::make_unique<CaptureScene>(options, node);
}

void writeSmallPicture(const std::string& fileName, OIIO::ImageBuf picture)
{
    picture.specmod().attribute("png:compressionLevel", 9);
    writePicture(fileName, picture);
}

void drawScene(const SceneLine& line, const std::string& folder, const std::string& output)
{
    const CaptureOptions options = toCaptureOptions(line, folder, output);
    const std::unique_ptr<CaptureScene> scene = createScene(line, options);
    // A separate context, so that no scene depends on those before.
    constexpr int UNUSED_SIZE = 16; // the picture has its own frame buffer
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(UNUSED_SIZE, UNUSED_SIZE, error);
    if (!context) throw CaptureError(EXIT_NO_GL, error);
    writeSmallPicture(output, toImageBuf(*ScenePicture(options, *scene, *context).draw()));
}

/** The lines with the given names, in the order of the names; all lines if there are no names. */
std::vector<SceneLine> choose(const std::vector<SceneLine>& lines, const std::vector<std::string>& names)
{
    if (names.empty()) return lines;
    std::vector<SceneLine> chosen;
    for (const std::string& name : names)
    {
        const auto found =
            std::find_if(lines.begin(), lines.end(), [&](const SceneLine& line) { return line.name == name; });
        if (found == lines.end()) throw CaptureError(EXIT_BAD_OPTIONS, "there is no scene '" + name + "'");
        chosen.push_back(*found);
    }
    return chosen;
}

int drawAll(const std::string& fileName, const std::string& outputFolder, const std::vector<std::string>& names)
{
    const std::string folder = std::filesystem::path(fileName).parent_path().string();
    std::filesystem::create_directories(outputFolder);
    int code = EXIT_FINE;
    for (const SceneLine& line : choose(readSceneFile(fileName), names))
    {
        if (!hasMesh(line))
        {
            fmt::print("{}: skipped, since its mesh has not been fetched\n", line.name);
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        try
        {
            drawScene(line, folder, (std::filesystem::path(outputFolder) / (line.name + ".png")).string());
        }
        catch (const CaptureError& error)
        {
            fmt::print("{}: {}\n", line.name, error.what());
            code = error.getCode();
            continue;
        }
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        fmt::print("{}: {:.0f} ms\n", line.name, time.count());
        std::fflush(stdout);
    }
    return code;
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() == 4 && arguments[0] == "--compare")
        return compareWithReferences(arguments[1], arguments[2], arguments[3]) == 0 ? EXIT_FINE : EXIT_DIFFERENT;
    if (arguments.size() >= 2 && arguments[0].front() != '-')
        return drawAll(arguments[0], arguments[1], {arguments.begin() + 2, arguments.end()});
    fmt::print(stderr, "{}", USAGE);
    return EXIT_BAD_OPTIONS;
}

} // namespace

} // namespace osgLego::test

int main(int argc, char** argv)
{
    try
    {
        return osgLego::test::run({argv + 1, argv + argc});
    }
    catch (const osgLego::CaptureError& error)
    {
        fmt::print(stderr, "regression-captures: {}\n", error.what());
        return error.getCode();
    }
    catch (const std::exception& error)
    {
        fmt::print(stderr, "regression-captures: {}\n", error.what());
        return osgLego::EXIT_BAD_INPUT;
    }
}
