#include "Contenders.h"

#include "LegoNodeContender.h"
#include "NativeContender.h"
#include "PlainLoopContender.h"
#include "baselines/DepthPictureContender.h"
#include "baselines/DominantAxisContender.h"
#include "baselines/SliceMapContender.h"

#include <osgLego/cpu/CpuVoxelizer.h>

#include <filesystem>
#include <stdexcept>

#include <osgDB/DynamicLibrary>

namespace osgLego
{

namespace
{

/** The exact method without GL, legolizeOnCpu, followed by an upload of the bricks. */
class CpuContender : public NativeContender
{
public:
    std::string getName() const override { return "exact, cpu"; }
    bool hasColors() const override { return true; }

protected:
    osg::ref_ptr<const BrickModel> findCells() override { return voxelizeOnCpu(getTriangles()); }
};

constexpr const char* OPENVDB_LIBRARY = "osglegobench_openvdb.so";

/** The path of the library in this program's build or installation; if it is not there, it is searched in
 * OSG_LIBRARY_PATH. */
std::string findOpenVdbLibrary()
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / ".." / "lib" / OPENVDB_LIBRARY;
    return fs::exists(beside, ignored) ? beside.string() : OPENVDB_LIBRARY;
}

/** Add the contenders of a library that is built only if OpenVDB is installed. */
void addOpenVdb(ContenderList& contenders)
{
    // Never unloaded, since contexts reference managers of its GL objects.
    static osgDB::DynamicLibrary* const library = osgDB::DynamicLibrary::loadLibrary(findOpenVdbLibrary());
    if (!library) return;
    using Create = Contender*(bool isNarrow);
    auto* create = reinterpret_cast<Create*>(library->getProcAddress("createOpenVdbContender"));
    for (const bool isNarrow : {false, true})
        contenders.emplace_back(create(isNarrow));
}

/** Move the contender with the given name out of `all`, or create one for settings of a LegoNode. */
std::unique_ptr<Contender> take(const std::string& name, ContenderList& all)
{
    if (name.find('=') != std::string::npos) return std::make_unique<LegoNodeContender>(name, name);
    std::string names;
    for (std::unique_ptr<Contender>& contender : all)
    {
        if (!contender) continue;
        if (contender->getName() == name) return std::move(contender);
        names += (names.empty() ? "'" : ", '") + contender->getName() + "'";
    }
    throw std::runtime_error("there is no contender '" + name + "'; expected one of " + names +
                             ", or settings of a LegoNode");
}

} // namespace

ContenderList createContenders()
{
    ContenderList contenders;
    const auto addLegoNode = [&contenders](const char* name, const char* settings)
    { contenders.push_back(std::make_unique<LegoNodeContender>(name, settings)); };
    addLegoNode("points, projected", "method=points,target=projected,edge=1,fbo=1024,device=gpu");
    addLegoNode("points, addressed", "method=points,target=addressed,edge=1,device=gpu");
    addLegoNode("exact, passes", "method=exact,device=gpu");
    addLegoNode("exact, node", "method=exact,device=auto");
    contenders.push_back(std::make_unique<CpuContender>());
    contenders.push_back(std::make_unique<DepthPictureContender>(DepthPictureContender::Method::KARABASSI));
    contenders.push_back(std::make_unique<DepthPictureContender>(DepthPictureContender::Method::PASSALIS));
    contenders.push_back(std::make_unique<SliceMapContender>());
    contenders.push_back(std::make_unique<DominantAxisContender>());
    contenders.push_back(std::make_unique<DominantAxisContender>(DominantAxisContender::Coverage::CONSERVATIVE));
    contenders.push_back(std::make_unique<PlainLoopContender>());
    addOpenVdb(contenders);
    return contenders;
}

ContenderList createContenders(const std::vector<std::string>& names)
{
    ContenderList all = createContenders();
    if (names.empty()) return all;
    ContenderList contenders;
    for (const std::string& name : names)
        contenders.push_back(take(name, all));
    return contenders;
}

} // namespace osgLego
