#pragma once

#include "GlRestoration.h"
#include "ReadBackContender.h"

#include <cstdint>
#include <vector>

#include <osg/Program>

namespace osgLego
{

/** Slice maps: Eisemann, Decoret, "Fast Scene Voxelization and Applications", 2006.
 *
 * The mesh is drawn once, along z, without depth test. Every fragment sets the bit of its cell in the bits of its
 * column, using GL's logic operation OR. This is the published method, except that a target has 128 bits (four 32-bit
 * integers) instead of 32, and the bit is computed instead of looked up. Several targets are drawn to at once; more
 * passes follow only if these do not suffice (beyond 1024 layers with GL's minimum of eight targets). There are no
 * colours, since a cell has only one bit. Walls parallel to z are missed between pixels.
 */
class SliceMapContender : public ReadBackContender
{
public:
    std::string getName() const override { return "slice map"; }
    bool hasColors() const override { return false; }

protected:
    std::string createObjects(osg::State& state) override;
    void gatherCells(osg::State& state, GatheredCells& cells) override;
    void releaseObjects() override;

private:
    using ClearBuffer = void(GL_APIENTRY*)(GLenum buffer, GLint drawBuffer, const GLuint* value);

    void readTarget(int target, int firstLayer, GatheredCells& cells);

    int _numTargets = 0;
    ClearBuffer _clearBuffer = nullptr;
    GlFramebuffer _framebuffer;
    std::vector<GlTexture> _targets;
    std::vector<std::uint32_t> _readBits;
    osg::ref_ptr<osg::Program> _program;
};

} // namespace osgLego
