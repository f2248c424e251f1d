#pragma once

#include "GlTest.h"

#include <array>
#include <vector>

#include <glm/vec4.hpp>
#include <osg/GraphicsContext>
#include <osg/StateSet>

namespace osgLego::test
{

/** A test of GLSL functions in shaders/: a vertex shader calls them, and transform feedback captures its output. */
class GlslFunctionTest : public GlTest
{
protected:
    using Arguments = std::array<glm::vec4, 4>;

    void SetUp() override;

    /** The value of `result` for each of the arguments.
     * @param name the name of the vertex shader, ending in .vert; each test needs a different one.
     * @param text the shader, without a version; it may include files of shaders/, reads the arguments vec4 a, b, c and
     * d, and writes vec4 result. The text must outlive the program.
     * @param stateSet the shader's uniforms and textures. */
    std::vector<glm::vec4> evaluate(const char* name, const char* text, const std::vector<Arguments>& arguments,
                                    osg::StateSet& stateSet);

private:
    osg::ref_ptr<osg::GraphicsContext> _context;
};

} // namespace osgLego::test
