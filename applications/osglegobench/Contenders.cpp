#include "Contenders.h"

#include "CpuContender.h"
#include "LegoNodeContender.h"
#include "PlainLoopContender.h"
#include "baselines/DominantAxisContender.h"
#include "baselines/KarabassiContender.h"
#include "baselines/PassalisContender.h"
#include "baselines/SliceMapContender.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <osgDB/DynamicLibrary>

namespace osgLego
{

namespace
{

constexpr const char* ON_GPU = ",device=gpu";
constexpr const char* OPENVDB_LIBRARY = "osglegobench_openvdb.so";

/** The library beside this program, in the build's folders or an installation's; elsewhere OSG_LIBRARY_PATH tells. */
std::string findOpenVdbLibrary()
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / ".." / "lib" / OPENVDB_LIBRARY;
    return fs::exists(beside, ignored) ? beside.string() : OPENVDB_LIBRARY;
}

/** Add those of a library that is there only where OpenVDB was when it was built. */
void addOpenVdb(ContenderList& contenders)
{
    static const osg::ref_ptr<osgDB::DynamicLibrary> library = osgDB::DynamicLibrary::loadLibrary(findOpenVdbLibrary());
    if (!library) return;
    using Create = Contender*(bool isNarrow);
    auto* create = reinterpret_cast<Create*>(library->getProcAddress("createOpenVdbContender"));
    for (const bool isNarrow : {false, true})
        contenders.emplace_back(create(isNarrow));
}

} // namespace

ContenderList createContenders()
{
    const std::string onGpu(ON_GPU);
    ContenderList contenders;
    contenders.push_back(std::make_unique<LegoNodeContender>(POINTS_PROJECTED,
                                                             "method=points,target=projected,edge=1,fbo=1024" + onGpu));
    contenders.push_back(
        std::make_unique<LegoNodeContender>(POINTS_ADDRESSED, "method=points,target=addressed,edge=1" + onGpu));
    contenders.push_back(std::make_unique<LegoNodeContender>(EXACT_PASSES, "method=exact" + onGpu));
    contenders.push_back(std::make_unique<LegoNodeContender>(EXACT_NODE, "method=exact,device=auto"));
    contenders.push_back(std::make_unique<CpuContender>());
    contenders.push_back(std::make_unique<KarabassiContender>());
    contenders.push_back(std::make_unique<PassalisContender>());
    contenders.push_back(std::make_unique<SliceMapContender>());
    contenders.push_back(std::make_unique<DominantAxisContender>());
    contenders.push_back(std::make_unique<DominantAxisContender>(DominantAxisContender::Coverage::CONSERVATIVE));
    contenders.push_back(std::make_unique<PlainLoopContender>());
    addOpenVdb(contenders);
    return contenders;
}

ContenderList createContenders(const std::vector<std::string>& names)
{
    ContenderList contenders = createContenders();
    std::string all;
    for (const auto& contender : contenders)
        all += (all.empty() ? "'" : ", '") + contender->getName() + "'";
    for (const std::string& name : names)
        if (std::none_of(contenders.begin(), contenders.end(),
                         [&name](const auto& contender) { return contender->getName() == name; }))
            throw std::runtime_error("there is no contender '" + name + "'; allowed: " + all);
    if (!names.empty())
        std::erase_if(contenders, [&names](const auto& contender)
                      { return std::find(names.begin(), names.end(), contender->getName()) == names.end(); });
    return contenders;
}

} // namespace osgLego
