#include "Footprint.h"

#include "ChildProcess.h"
#include "Contenders.h"
#include "ResidentMemory.h"
#include "VoxelizeBench.h"

#include <sstream>
#include <stdexcept>

namespace osgLego
{

namespace
{

void runTwice(Contender& contender, const BenchMesh& mesh, osg::GraphicsContext& context)
{
    const std::string failure = contender.prepare(mesh, context);
    if (!failure.empty()) throw std::runtime_error(failure);
    contender.run();
    contender.run();
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
    resetPeakMemory();
    const double before = readPeakMemory();
    runTwice(*contenders.front(), mesh, *context);
    const double after = readPeakMemory();
    contenders.front()->release();
    return after - before;
}

std::optional<double> measureFootprintApart(const MeshSource& source, unsigned int resolution,
                                            const std::string& contender)
{
    const auto output = runThisProgram({"footprint", "--mesh", source.toString(), "--resolution",
                                        std::to_string(resolution), "--contender", contender});
    if (!output) return std::nullopt;
    double megabytes = 0.0;
    return std::istringstream(*output) >> megabytes ? std::optional(megabytes) : std::nullopt;
}

} // namespace osgLego
