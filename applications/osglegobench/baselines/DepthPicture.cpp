#include "DepthPicture.h"

#include <algorithm>
#include <bit>

namespace osgLego
{

std::string DepthPicture::create(const osg::State& state, const glm::ivec3& dimensions, int axis, std::size_t numDepths)
{
    _dimensions = dimensions;
    _axis = axis;
    _size = glm::ivec2(dimensions[(axis + 1) % 3], dimensions[(axis + 2) % 3]);
    _depthRange = osgLego::getDepthRange(dimensions[axis]);
    if (std::string error = checkTextureSide(std::max(_size.x, _size.y), GL_MAX_TEXTURE_SIZE); !error.empty())
        return error;
    _color = createGlTexture2D(state, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, _size);
    _targets.clear();
    for (std::size_t number = 0; number < numDepths; ++number)
        if (!createTarget(state)) return "GL can't draw to a texture of colours and one of 32-bit depths together";
    return {};
}

bool DepthPicture::createTarget(const osg::State& state)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    _targets.push_back(
        {createGlTexture2D(state, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, _size), GlFramebuffer(state)});
    const Target& target = _targets.back();
    extensions.glBindFramebuffer(GL_FRAMEBUFFER_EXT, target.framebuffer.get());
    extensions.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, _color.get(), 0);
    extensions.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, GL_DEPTH_ATTACHMENT_EXT, GL_TEXTURE_2D, target.depth.get(),
                                      0);
    return extensions.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
}

void DepthPicture::begin(const osg::State& state, std::size_t depthTexture, double depth) const
{
    state.get<osg::GLExtensions>()->glBindFramebuffer(GL_FRAMEBUFFER_EXT, _targets[depthTexture].framebuffer.get());
    glViewport(0, 0, _size.x, _size.y);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(depth);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void DepthPicture::setUniforms(const ProgramUniforms& uniforms) const
{
    uniforms.set("axis", _axis);
    uniforms.set("pictureSize", glm::vec2(_size));
    uniforms.set("depthRange", _depthRange);
}

void DepthPicture::readCells(GatheredCells& cells)
{
    const auto numPixels = static_cast<std::size_t>(_size.x) * static_cast<std::size_t>(_size.y);
    _readColors.resize(numPixels);
    _readDepths.resize(numPixels);
    glReadPixels(0, 0, _size.x, _size.y, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, _readColors.data());
    glReadPixels(0, 0, _size.x, _size.y, GL_DEPTH_COMPONENT, GL_FLOAT, _readDepths.data());

    std::size_t pixel = 0;
    glm::ivec3 cell;
    int& across = cell[(_axis + 1) % 3];
    int& up = cell[(_axis + 2) % 3];
    for (up = 0; up < _size.y; ++up)
        for (across = 0; across < _size.x; ++across, ++pixel)
        {
            if (_readColors[pixel] == 0) continue;
            cell[_axis] = std::min(static_cast<int>(_readDepths[pixel] * _depthRange), _dimensions[_axis] - 1);
            cells.add(cell, _readColors[pixel]);
        }
}

float getDepthRange(int numCells)
{
    return static_cast<float>(std::bit_ceil(static_cast<unsigned int>(numCells)));
}

} // namespace osgLego
