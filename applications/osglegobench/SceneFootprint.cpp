#include "SceneFootprint.h"

#include "AllocationCount.h"
#include "BenchEnvironment.h"
#include "BenchView.h"
#include "ChildProcess.h"
#include "GlWatch.h"
#include "ResidentMemory.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace osgLego
{

namespace
{

constexpr glm::ivec2 SIZE(1280, 720);

double toMebibytes(std::size_t bytes)
{
    return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

BenchScene createScene(const MeshSource& source, unsigned int resolution, const std::string& device)
{
    BenchScene scene = createBenchScene(source, resolution);
    std::string error;
    if (!LegoSettings::parse("device=" + device, scene.settings, error)) throw std::runtime_error(error);
    return scene;
}

} // namespace

SceneFootprint SceneFootprint::measure(const MeshSource& source, unsigned int resolution, const std::string& device)
{
    GlLedger ledger;
    SceneFootprint result;
    GlWatch::setLedger(&ledger);
    {
        BenchView view(createScene(source, resolution, device), SIZE, PictureUse::DISCARD);
        view.drawFrame(AmbientOcclusionSettings());
        result.numDrawnBricks = view.getStatistics().numDrawnBricks;
        result.isSoftware = BenchEnvironment::find(view.getContext()).isSoftware();
    }
    GlWatch::setLedger(nullptr);
    if (result.numDrawnBricks == 0) throw std::runtime_error("the frame shows no bricks");
    result.resident = readPeakMemory();
    result.gl = toMebibytes(ledger.getPeak());
    result.largestGl = toMebibytes(ledger.getLargest().bytes);
    result.largestGlObject = ledger.getLargest().description;
    result.largestBlock = toMebibytes(AllocationCount::findLargestBlock());
    return result;
}

std::optional<SceneFootprint> SceneFootprint::measureApart(const MeshSource& source, unsigned int resolution,
                                                           const std::string& device)
{
    const auto output = runThisProgram(
        {"footprint", "--mesh", source.toString(), "--resolution", std::to_string(resolution), "--frame-by", device});
    return output ? fromText(*output) : std::nullopt;
}

std::string SceneFootprint::toText() const
{
    return nlohmann::json{{"resident", resident},         {"gl", gl},
                          {"largestGl", largestGl},       {"largestGlObject", largestGlObject},
                          {"largestBlock", largestBlock}, {"drawnBricks", numDrawnBricks},
                          {"software", isSoftware}}
        .dump();
}

std::optional<SceneFootprint> SceneFootprint::fromText(const std::string& text)
{
    try
    {
        const nlohmann::json json = nlohmann::json::parse(text);
        SceneFootprint result;
        json.at("resident").get_to(result.resident);
        json.at("gl").get_to(result.gl);
        json.at("largestGl").get_to(result.largestGl);
        json.at("largestGlObject").get_to(result.largestGlObject);
        json.at("largestBlock").get_to(result.largestBlock);
        json.at("drawnBricks").get_to(result.numDrawnBricks);
        json.at("software").get_to(result.isSoftware);
        return result;
    }
    catch (const nlohmann::json::exception&)
    {
        return std::nullopt;
    }
}

} // namespace osgLego
