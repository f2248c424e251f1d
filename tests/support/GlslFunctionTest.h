#pragma once

#include "GlTest.h"

#include <array>
#include <vector>

#include <glm/vec4.hpp>
#include <osg/GraphicsContext>
#include <osg/StateSet>

namespace osgLego::test
{

/** A test of functions in files of shaders/: a vertex shader calls them, and its output is captured. */
class GlslFunctionTest : public GlTest
{
protected:
    using Arguments = std::array<glm::vec4, 4>;

    void SetUp() override;

    /** Run a shader for each of the arguments.
     * @param name of the vertex shader, with the ending .vert; unlike that of any other test.
     * @param text the shader, without a version, which may include files of shaders/ and outlives the program: it reads
     * vec4 a, b, c and d, the arguments, and writes to vec4 result.
     * @param stateSet the shader's uniforms and textures. */
    std::vector<glm::vec4> evaluate(const char* name, const char* text, const std::vector<Arguments>& arguments,
                                    osg::StateSet& stateSet);

private:
    osg::ref_ptr<osg::GraphicsContext> _context;
};

} // namespace osgLego::test
