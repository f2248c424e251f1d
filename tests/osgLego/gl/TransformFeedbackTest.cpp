#include <osgLego/gl/TransformFeedback.h>

#include <GlTest.h>

#include <osg/Program>

namespace osgLego::test
{

namespace
{

class TransformFeedbackTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _context->makeCurrent();
        osg::State& state = *_context->getState();
        _extensions = state.get<osg::GLExtensions>();
        _program = new osg::Program;
        _program->addShader(new osg::Shader(osg::Shader::VERTEX, "#version 400 compatibility\n"
                                                                 "layout(location = 0) in float vertex;\n"
                                                                 "out float value;\n"
                                                                 "void main() { value = vertex; }\n"));
        _program->addTransformFeedBackVarying("value");
        state.applyAttribute(_program);
        _extensions->glGenBuffers(1, &_buffer);
        _extensions->glBindBuffer(GL_ARRAY_BUFFER, _buffer);
        _extensions->glBufferData(GL_ARRAY_BUFFER, 10 * sizeof(float), nullptr, GL_DYNAMIC_COPY);
        // Some drivers derive the number of vertices from the stride of the first array. NVIDIA's rejects one that is
        // in the buffer captured into.
        _extensions->glGenBuffers(1, &_vertices);
        _extensions->glBindBuffer(GL_ARRAY_BUFFER, _vertices);
        _extensions->glBufferData(GL_ARRAY_BUFFER, 10 * sizeof(float), nullptr, GL_STATIC_DRAW);
        _extensions->glEnableVertexAttribArray(0);
        _extensions->glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
        _extensions->glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    void TearDown() override
    {
        _extensions->glDisableVertexAttribArray(0);
        _extensions->glDeleteBuffers(1, &_buffer);
        _extensions->glDeleteBuffers(1, &_vertices);
        GlTest::TearDown();
    }

    CapturedPrimitives capture(TransformFeedback& feedback, int points, GLsizeiptr room)
    {
        feedback.begin(GL_POINTS, _buffer, 0, room * static_cast<GLsizeiptr>(sizeof(float)));
        glDrawArrays(GL_POINTS, 0, points);
        feedback.end();
        return feedback.getResult();
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osg::Program> _program;
    const osg::GLExtensions* _extensions = nullptr;
    GLuint _buffer = 0;
    GLuint _vertices = 0;
};

TEST_F(TransformFeedbackTest, CountsPrimitivesGeneratedAndWritten)
{
    TransformFeedback feedback(*_extensions);
    const CapturedPrimitives enough = capture(feedback, 7, 10);
    EXPECT_EQ(enough.generated, 7u);
    EXPECT_EQ(enough.written, 7u);
    EXPECT_TRUE(enough.isComplete());
    const CapturedPrimitives tooFew = capture(feedback, 7, 5);
    EXPECT_EQ(tooFew.generated, 7u);
    EXPECT_EQ(tooFew.written, 5u);
    EXPECT_FALSE(tooFew.isComplete());
}

TEST_F(TransformFeedbackTest, DrawsAllThatItCaptured)
{
    TransformFeedback first(*_extensions);
    capture(first, 6, 10);
    TransformFeedback second(*_extensions);
    GLuint other = 0;
    _extensions->glGenBuffers(1, &other);
    _extensions->glBindBuffer(GL_ARRAY_BUFFER, other);
    _extensions->glBufferData(GL_ARRAY_BUFFER, 10 * sizeof(float), nullptr, GL_DYNAMIC_COPY);
    second.begin(GL_POINTS, other, 0, 10 * sizeof(float));
    first.draw(GL_POINTS);
    second.end();
    EXPECT_EQ(second.getResult().written, 6u);
    _extensions->glDeleteBuffers(1, &other);
}

TEST_F(TransformFeedbackTest, LeavesRasterizationOn)
{
    TransformFeedback feedback(*_extensions);
    capture(feedback, 1, 10);
    EXPECT_FALSE(glIsEnabled(GL_RASTERIZER_DISCARD));
    GLint bound = -1;
    glGetIntegerv(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, &bound);
    EXPECT_EQ(bound, 0);
}

} // namespace

} // namespace osgLego::test
