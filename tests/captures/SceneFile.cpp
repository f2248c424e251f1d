#include "SceneFile.h"

#include <osglegocapture/ExitCode.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace osgLego::test
{

namespace
{

constexpr const char* ALIASED = "--aliased";

std::string findBunny()
{
    const char* folder = std::getenv("OSGLEGO_TEST_MODELS");
    const std::filesystem::path path = std::filesystem::path(folder ? folder : ".") / "bunny.ply";
    return std::filesystem::exists(path) ? path.string() : std::string();
}

} // namespace

std::vector<SceneLine> readSceneFile(const std::string& fileName)
{
    std::ifstream file(fileName);
    if (!file) throw CaptureError(EXIT_BAD_INPUT, "can't read '" + fileName + "'");
    std::vector<SceneLine> lines;
    for (std::string text; std::getline(file, text);)
    {
        std::istringstream words(text);
        SceneLine line;
        if (!(words >> line.name) || line.name.front() == '#') continue;
        if (!(words >> line.mesh)) throw CaptureError(EXIT_BAD_INPUT, "scene '" + line.name + "' names no mesh");
        for (std::string option; words >> option;)
            line.options.push_back(option);
        lines.push_back(line);
    }
    return lines;
}

CaptureOptions toCaptureOptions(const SceneLine& line, const std::string& folder, const std::string& output)
{
    std::vector<std::string> words{"osglegocapture", "-o", output};
    if (line.mesh == "bunny") words.push_back(findBunny());
    const auto isOwn = [](const std::string& option) { return option == ALIASED; };
    std::remove_copy_if(line.options.begin(), line.options.end(), std::back_inserter(words), isOwn);
    std::vector<char*> arguments;
    arguments.reserve(words.size());
    for (std::string& word : words)
        arguments.push_back(word.data());
    CaptureOptions options;
    if (readOptions(static_cast<int>(arguments.size()), arguments.data(), options))
        throw CaptureError(EXIT_BAD_OPTIONS, "scene '" + line.name + "' has bad options");
    if (std::any_of(line.options.begin(), line.options.end(), isOwn)) options.samples = 1;
    if (!options.probe.file.empty()) options.probe.file = (std::filesystem::path(folder) / options.probe.file).string();
    return options;
}

bool hasMesh(const SceneLine& line)
{
    return line.mesh != "bunny" || !findBunny().empty();
}

} // namespace osgLego::test
