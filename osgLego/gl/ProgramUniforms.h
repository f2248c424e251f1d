#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <osg/GLExtensions>
#include <osg/Matrixd>
#include <osg/Program>
#include <osg/State>
#include <osg/Uniform>

namespace osgLego
{

/** The name of a uniform, as the ID that OSG gives it. Make it static to avoid a look-up in every draw call. */
struct UniformName
{
    UniformName(const char* name) : id(osg::Uniform::getNameID(name)) {}

    unsigned int id;
};

/** Sets uniforms, by name and immediately, in the program that a state has applied last.
 *
 * For values that change from draw call to draw call. Names that the program does not use are ignored. Needs the
 * context of the state current.
 */
class ProgramUniforms
{
public:
    explicit ProgramUniforms(const osg::State& state) :
        _extensions(*state.get<osg::GLExtensions>()), _program(*state.getLastAppliedProgramObject())
    {
    }

    /** Whether the program uses a uniform of this name. */
    bool has(const UniformName& name) const { return find(name) >= 0; }

    void set(const UniformName& name, int value) const { _extensions.glUniform1i(find(name), value); }
    void set(const UniformName& name, float value) const { _extensions.glUniform1f(find(name), value); }
    void set(const UniformName& name, const int* values, GLsizei count) const
    {
        _extensions.glUniform1iv(find(name), count, values);
    }
    void set(const UniformName& name, const float* values, GLsizei count) const
    {
        _extensions.glUniform1fv(find(name), count, values);
    }
    void set(const UniformName& name, const glm::ivec2& value) const
    {
        _extensions.glUniform2iv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::ivec4& value) const
    {
        _extensions.glUniform4iv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::vec2& value) const
    {
        _extensions.glUniform2fv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::vec3& value) const
    {
        _extensions.glUniform3fv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::vec4& value) const
    {
        _extensions.glUniform4fv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::vec4* values, GLsizei count) const
    {
        _extensions.glUniform4fv(find(name), count, glm::value_ptr(*values));
    }
    void set(const UniformName& name, const glm::ivec3& value) const
    {
        _extensions.glUniform3iv(find(name), 1, &value.x);
    }
    void set(const UniformName& name, const glm::mat3& value) const
    {
        _extensions.glUniformMatrix3fv(find(name), 1, GL_FALSE, &value[0].x);
    }
    void set(const UniformName& name, const glm::mat4& value) const { set(name, &value, 1); }
    void set(const UniformName& name, const glm::mat4* values, GLsizei count) const
    {
        _extensions.glUniformMatrix4fv(find(name), count, GL_FALSE, glm::value_ptr(*values));
    }

private:
    GLint find(const UniformName& name) const { return _program.getUniformLocation(name.id); }

    const osg::GLExtensions& _extensions;
    const osg::Program::PerContextProgram& _program;
};

/** Convert a matrix from OSG, which multiplies row vectors, to GLSL, which multiplies column vectors. */
inline glm::mat4 toGlsl(const osg::Matrixd& matrix)
{
    return glm::mat4(glm::make_mat4(matrix.ptr()));
}

/** The rotation of a transform that consists of rotation, scale and translation. */
inline glm::mat3 rotationOf(const osg::Matrixd& matrix)
{
    const glm::mat3 linear(toGlsl(matrix));
    return {glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2])};
}

/** The same rotation, as the value of a uniform. */
inline osg::Matrix3 toUniform(const osg::Matrixd& matrix)
{
    const glm::mat3 rotation = rotationOf(matrix);
    osg::Matrix3 result;
    std::copy_n(&rotation[0].x, 9, result.ptr());
    return result;
}

} // namespace osgLego
