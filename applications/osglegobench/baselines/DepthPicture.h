#pragma once

#include "GatheredCells.h"
#include "GlRestoration.h"

#include <osgLego/gl/ProgramUniforms.h>

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** An orthographic picture of a grid along one of its axes, one pixel per column of cells: depths, and colours with an
 * alpha of 1 where there is a surface.
 *
 * Depth is the position along the axis divided by a power of two, for both view directions, so that the numbers of
 * cells are read back without rounding.
 */
class DepthPicture
{
public:
    /** @param numDepths the number of depth textures; one at a time is drawn to.
     * @return an error message, in one sentence; empty on success. */
    std::string create(const osg::State& state, const glm::ivec3& dimensions, int axis, std::size_t numDepths);

    /** Clear the picture and bind it for drawing. @param depth the depth of an empty pixel, 0 or 1. */
    void begin(const osg::State& state, std::size_t depthTexture, double depth) const;
    /** Set the uniforms of depth_picture.vert. */
    void setUniforms(const ProgramUniforms& uniforms) const;
    GLuint getDepthTexture(std::size_t number) const { return _targets[number].depth.get(); }

    /** Read the picture back, and add the cells of all pixels that are not empty. */
    void readCells(GatheredCells& cells);

private:
    // A frame buffer for each, since attaching another texture is more expensive than binding another frame buffer.
    struct Target
    {
        GlTexture depth;
        GlFramebuffer framebuffer;
    };

    bool createTarget(const osg::State& state);

    glm::ivec3 _dimensions{0};
    int _axis = 0;
    glm::ivec2 _size{0};
    float _depthRange = 1.0f; // cells
    GlTexture _color;
    std::vector<Target> _targets;
    std::vector<std::uint32_t> _readColors;
    std::vector<float> _readDepths;
};

/** The number of cells for depths from 0 to 1, given the number of cells along the axis: the next power of two. */
float getDepthRange(int numCells);

} // namespace osgLego
