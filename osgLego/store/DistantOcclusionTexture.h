#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/DistantOcclusion.h>

#include <array>

#include <glm/vec3.hpp>
#include <osg/Matrixd>
#include <osg/Referenced>
#include <osg/Texture3D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Distant occlusion as two textures with linear interpolation, and the transform from cells to texture coordinates,
 * `scale * cell + offset`. The cells are those of the grid for which it was computed, which may be an earlier one than
 * that of the bricks. */
class DistantOcclusionTexture : public osg::Referenced
{
public:
    DistantOcclusionTexture(const DistantOcclusion& occlusion, const BrickGrid& grid);
    /** Create a texture without occlusion, for bricks whose occlusion is not known yet. */
    DistantOcclusionTexture();

    /** DistantOcclusion::getMean() and getBend(). */
    osg::Texture3D& getMean() const { return *_textures[0]; }
    osg::Texture3D& getBend() const { return *_textures[1]; }
    bool includesNear() const { return _includesNear; }
    const glm::vec3& getScale() const { return _scale; }
    const glm::vec3& getOffset() const { return _offset; }
    /** The extent of a voxel, in texture coordinates. */
    const glm::vec3& getVoxel() const { return _voxel; }

    const osg::Matrixd& getCellsToModel() const { return _cellsToModel; }

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~DistantOcclusionTexture() override = default;

    std::array<osg::ref_ptr<osg::Texture3D>, 2> _textures;
    bool _includesNear = false;
    osg::Matrixd _cellsToModel;
    glm::vec3 _scale{1.0f};
    glm::vec3 _offset{0.5f};
    glm::vec3 _voxel{1.0f};
};

} // namespace osgLego
