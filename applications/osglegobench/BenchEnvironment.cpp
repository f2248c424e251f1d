#include "BenchEnvironment.h"

#include <BenchCommit.h>

#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include <osg/GL>

namespace osgLego
{

namespace
{

std::string glText(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "unknown";
}

/** As Linux tells it. */
std::string findProcessor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

std::string findDate()
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

} // namespace

BenchEnvironment BenchEnvironment::find(osg::GraphicsContext& context)
{
    context.makeCurrent();
    return {glText(GL_RENDERER), glText(GL_VERSION), findProcessor(), std::thread::hardware_concurrency(),
            OSGLEGO_COMMIT,      findDate()};
}

bool BenchEnvironment::isSoftware() const
{
    for (const char* name : {"llvmpipe", "softpipe", "SWR", "Software"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

std::vector<std::pair<std::string, std::string>> BenchEnvironment::toFields() const
{
    return {{"renderer", renderer},   {"version", version},
            {"processor", processor}, {"threads", std::to_string(numThreads)},
            {"commit", commit},       {"date", date}};
}

} // namespace osgLego
