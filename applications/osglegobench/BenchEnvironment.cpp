#include "BenchEnvironment.h"

#include <BenchCommit.h>
#include <offscreen/OffscreenContext.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fmt/chrono.h>
#include <osg/GL>

namespace osgLego
{

namespace
{

std::string getGlText(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "unknown";
}

/** The name of the processor, from Linux. */
std::string findProcessor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

JsonValue describeMachine()
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return {{"processor", findProcessor()},
            {"threads", std::to_string(std::thread::hardware_concurrency())},
            {"commit", OSGLEGO_COMMIT},
            {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))}};
}

} // namespace

osg::ref_ptr<osg::GraphicsContext> createBenchContext(int width, int height)
{
    std::string error;
    osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(width, height, error);
    if (!context) throw std::runtime_error(error);
    context->makeCurrent();
    return context;
}

JsonValue createDocument(const std::string& benchmark)
{
    return {{"benchmark", benchmark}, {"environment", describeMachine()}};
}

JsonValue createDocument(const std::string& benchmark, osg::GraphicsContext& context)
{
    context.makeCurrent();
    JsonValue environment{{"renderer", getGlText(GL_RENDERER)}, {"version", getGlText(GL_VERSION)}};
    environment.update(describeMachine());
    return {{"benchmark", benchmark}, {"environment", environment}};
}

bool isSoftwareRenderer()
{
    const std::string renderer = getGlText(GL_RENDERER);
    for (const char* name : {"llvmpipe", "softpipe", "SWR", "Software"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

} // namespace osgLego
