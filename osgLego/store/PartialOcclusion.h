#pragma once

#include <osgLego/data/BuildingSet.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/store/GridOcclusionTextures.h>

#include <cstdint>
#include <optional>

#include <osg/Referenced>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** The GL objects for the grid occlusion of a partly built model in a context: the ranks of its cells, uploaded once,
 * and the neighbours of its bricks, which a pass finds on the GPU (findPartialNeighbors()). */
class PartialOcclusion : public osg::Referenced
{
public:
    /** Upload the ranks. Needs the context of the state current; the caller checks for lack of memory. */
    PartialOcclusion(const osg::State& state, const BuildingSet& building);

    /** The ranks of createRankBlocks(), as a buffer texture. */
    GLuint getRanks() const { return _ranks.get(); }
    /** The neighbours of BuildingPoints, and the tables. */
    const GridOcclusionTextures& getTextures() const { return *_textures; }

    /** The number of parts in place for which the neighbours were found; nothing if they are not known yet. */
    std::optional<std::uint32_t> numPlaced;

private:
    ~PartialOcclusion() override = default;

    GlBuffer _rankBuffer;
    GlTexture _ranks;
    osg::ref_ptr<GridOcclusionTextures> _textures;
};

} // namespace osgLego
