#include "Harness.h"
#include "RandomMesh.h"

#include <osgLego/CpuLegolizer.h>

#include <vector>

#include <oneapi/tbb/global_control.h>

// Meshes, as readers of other formats may create them, become bricks on the CPU.

namespace
{

using osgLego::fuzz::require;

// Threads cost more than they save in grids of this size.
const oneapi::tbb::global_control oneThread(oneapi::tbb::global_control::max_allowed_parallelism, 1);

/** Settings of small grids, since the mesh is the untrusted part. None computes forces or
 * the tables of other palettes, which take seconds to minutes under sanitizers and do not depend on the mesh itself. */
const std::vector<osgLego::LegoSettings>& getSettings()
{
    static const std::vector<osgLego::LegoSettings> all = []
    {
        std::vector<osgLego::LegoSettings> read;
        for (const char* text : {"6", "1,up=y", "4,proportions=plate,parts=bricks,effort=instant", "7,fill=solid",
                                 "4,up=y,proportions=brick,parts=bricks,effort=instant,connect=on", "6,palette=ldraw",
                                 "cell=2", "cell=0.25,origin=-1:-1:-1,size=8:8:8", "4,anchor=model"})
        {
            std::string error;
            require(osgLego::LegoSettings::parse(text, read.emplace_back(), error), "the settings are valid: " + error);
        }
        return read;
    }();
    return all;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    osgLego::ByteReader reader(osgLego::fuzz::toText(data, size));
    const osgLego::LegoSettings& settings = getSettings()[reader.readNumber<std::uint8_t>() % getSettings().size()];
    const osg::ref_ptr<osg::Node> mesh = osgLego::fuzz::createRandomMesh(reader);
    const osg::ref_ptr<const osgLego::BrickModel> model = osgLego::legolizeOnCpu(*mesh, settings);
    if (model) osgLego::fuzz::requirePossible(*model);
    return 0;
}
