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
 * The mesh is drawn once, along z, without depth test; every fragment sets the bit of its cell in the bits of its
 * column, which the logic operation OR gathers. As published, but for 128 bits a target (four 32-bit integers) instead
 * of 32, and the bit computed instead of looked up. Several targets are drawn to at once, and more passes follow only
 * where these do not suffice (beyond 1024 layers with GL's minimum of eight). No colours: a bit is all there is of a
 * cell. Walls along z fall between pixels.
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
