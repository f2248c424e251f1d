#include "VoxelizeResults.h"

namespace osgLego
{

const ContenderResult* MeshResult::find(const std::string& contender) const
{
    for (const ContenderResult& result : contenders)
        if (result.contender == contender && result.failure.empty()) return &result;
    return nullptr;
}

const MeshResult* VoxelizeResults::find(const std::string& mesh, unsigned int resolution) const
{
    for (const MeshResult& result : meshes)
        if (result.mesh == mesh && result.resolution == resolution) return &result;
    return nullptr;
}

} // namespace osgLego
