#include "Footprint.h"

#include "Contenders.h"
#include "VoxelizeBench.h"

#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

/** The most memory that was ever resident, in megabytes. */
double readPeak()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
    throw std::runtime_error("/proc/self/status tells no VmHWM");
}

/** From here on, the peak is what there is now. */
void resetPeak()
{
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

void runTwice(Contender& contender, const BenchMesh& mesh, osg::GraphicsContext& context)
{
    const std::string failure = contender.prepare(mesh, context);
    if (!failure.empty()) throw std::runtime_error(failure);
    contender.run();
    contender.run();
}

/** All that a program writes; nothing when it fails. */
std::optional<std::string> readOutput(std::vector<std::string> arguments)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe to be had");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    std::string output;
    std::array<char, 256> buffer{};
    for (ssize_t size = 0; error == 0 && (size = read(ends[0], buffer.data(), buffer.size())) > 0;)
        output.append(buffer.data(), static_cast<std::size_t>(size));
    close(ends[0]);
    int status = 0;
    if (error != 0 || waitpid(child, &status, 0) != child || status != 0) return std::nullopt;
    return output;
}

} // namespace

double measureFootprint(const MeshSource& source, unsigned int resolution, const std::string& contender)
{
    constexpr unsigned int LITTLE = 8;
    const ContenderList contenders = createContenders({contender});
    const osg::ref_ptr<osg::GraphicsContext> context = createBenchContext();
    const osg::ref_ptr<osg::Node> node = readMesh(source);
    const BenchMesh mesh = createBenchMesh(source, *node, resolution);
    runTwice(*contenders.front(), createBenchMesh(source, *node, LITTLE), *context);
    contenders.front()->release();
    resetPeak();
    const double before = readPeak();
    runTwice(*contenders.front(), mesh, *context);
    const double after = readPeak();
    contenders.front()->release();
    return after - before;
}

std::optional<double> measureFootprintApart(const MeshSource& source, unsigned int resolution,
                                            const std::string& contender)
{
    const auto output = readOutput({"osglegobench", "footprint", "--mesh", source.toString(), "--resolution",
                                    std::to_string(resolution), "--contender", contender});
    if (!output) return std::nullopt;
    double megabytes = 0.0;
    return std::istringstream(*output) >> megabytes ? std::optional(megabytes) : std::nullopt;
}

} // namespace osgLego
