#pragma once

#include <osgLego/data/DistantOcclusion.h>

#include <array>

#include <glm/vec3.hpp>
#include <osg/Referenced>
#include <osg/Texture3D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Distant occlusion as two textures with linear interpolation, and the transform from cells to texture coordinates,
 * `scale * cell + offset`. */
class DistantOcclusionTexture : public osg::Referenced
{
public:
    explicit DistantOcclusionTexture(const DistantOcclusion& occlusion);
    /** Create a texture without occlusion, for bricks whose occlusion is not known yet. */
    DistantOcclusionTexture();

    /** The hidden fractions of surfaces that face the upper or lower ends of the axes. */
    osg::Texture3D& getTexture(bool upper) const { return *_textures[upper ? 1 : 0]; }
    const glm::vec3& getScale() const { return _scale; }
    const glm::vec3& getOffset() const { return _offset; }
    /** The extent of a voxel, in texture coordinates. */
    const glm::vec3& getVoxel() const { return _voxel; }

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~DistantOcclusionTexture() override = default;

    std::array<osg::ref_ptr<osg::Texture3D>, 2> _textures;
    glm::vec3 _scale{1.0f};
    glm::vec3 _offset{0.5f};
    glm::vec3 _voxel{1.0f};
};

} // namespace osgLego
