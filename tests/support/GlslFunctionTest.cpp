#include "GlslFunctionTest.h"

#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/TransformFeedback.h>

#include <osg/GLExtensions>
#include <osg/Program>

namespace osgLego::test
{

namespace
{

constexpr const char* DECLARATIONS = "layout(location = 0) in vec4 a;\n"
                                     "layout(location = 1) in vec4 b;\n"
                                     "layout(location = 2) in vec4 c;\n"
                                     "layout(location = 3) in vec4 d;\n"
                                     "out vec4 result;\n";

/** A buffer of vectors, deleted at the end. */
class VectorBuffer
{
public:
    VectorBuffer(const osg::GLExtensions& extensions, std::size_t count, const void* data) : _extensions(extensions)
    {
        _extensions.glGenBuffers(1, &_name);
        _extensions.glBindBuffer(GL_ARRAY_BUFFER, _name);
        _extensions.glBufferData(GL_ARRAY_BUFFER, sizeOf(count), data, GL_STATIC_DRAW);
    }
    ~VectorBuffer() { _extensions.glDeleteBuffers(1, &_name); }
    VectorBuffer(const VectorBuffer&) = delete;
    VectorBuffer& operator=(const VectorBuffer&) = delete;

    static GLsizeiptr sizeOf(std::size_t count) { return static_cast<GLsizeiptr>(count * sizeof(glm::vec4)); }
    GLuint getName() const { return _name; }

private:
    const osg::GLExtensions& _extensions;
    GLuint _name = 0;
};

} // namespace

void GlslFunctionTest::SetUp()
{
    GlTest::SetUp();
    _context = createContext();
    _context->makeCurrent();
}

std::vector<glm::vec4> GlslFunctionTest::evaluate(const char* name, const char* text,
                                                  const std::vector<Arguments>& arguments, osg::StateSet& stateSet)
{
    ShaderLibrary::add({{name, text}});
    const osg::ref_ptr<osg::Program> program = ShaderLibrary::getProgram(name, {name}, DECLARATIONS);
    program->addTransformFeedBackVarying("result");
    stateSet.setAttributeAndModes(program);
    osg::State& state = *_context->getState();
    state.apply(&stateSet);
    EXPECT_TRUE(state.getLastAppliedProgramObject());

    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    std::vector<glm::vec4> results(arguments.size());
    const VectorBuffer output(extensions, results.size(), nullptr);
    const VectorBuffer input(extensions, 4 * arguments.size(), arguments.data());
    for (GLuint argument = 0; argument < 4; ++argument)
    {
        extensions.glEnableVertexAttribArray(argument);
        extensions.glVertexAttribPointer(argument, 4, GL_FLOAT, GL_FALSE, sizeof(Arguments),
                                         reinterpret_cast<const void*>(argument * sizeof(glm::vec4)));
    }
    TransformFeedback feedback(extensions);
    feedback.begin(GL_POINTS, output.getName(), 0, VectorBuffer::sizeOf(results.size()));
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(arguments.size()));
    feedback.end();
    EXPECT_TRUE(feedback.getResult().isComplete());
    for (GLuint argument = 0; argument < 4; ++argument)
        extensions.glDisableVertexAttribArray(argument);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, output.getName());
    extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0, VectorBuffer::sizeOf(results.size()), results.data());
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    return results;
}

} // namespace osgLego::test
