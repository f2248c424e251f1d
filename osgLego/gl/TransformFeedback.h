#pragma once

#include <osg/GL>
#include <osg/GLExtensions>

namespace osgLego
{

/** What a transform feedback was given, and what of it found room. */
struct CapturedPrimitives
{
    GLuint generated = 0;
    GLuint written = 0;

    bool isComplete() const { return generated == written; }
};

/** A GL transform feedback object and the two queries that tell whether its buffer was large enough.
 *
 * Rasterization is off while capturing. All functions, constructor and destructor included, need the context current
 * in which the object was made; transform feedback objects are not shared between contexts (OpenGL 4.6, chapter 5).
 *
 * Usage:
 *
 *     TransformFeedback feedback(extensions);
 *     feedback.begin(GL_TRIANGLES, buffer, 0, size);
 *     ... draw ...
 *     feedback.end();
 *     if (!feedback.getResult().isComplete()) ... // grow the buffer and draw again
 *
 * https://registry.khronos.org/OpenGL-Refpages/gl4/html/glBeginTransformFeedback.xhtml
 */
class TransformFeedback
{
public:
    explicit TransformFeedback(const osg::GLExtensions& extensions);
    ~TransformFeedback();
    TransformFeedback(const TransformFeedback&) = delete;
    TransformFeedback& operator=(const TransformFeedback&) = delete;

    /** Capture `primitives` (GL_POINTS, GL_LINES, GL_TRIANGLES) into bytes `offset` to `offset + size` of `buffer`. */
    void begin(GLenum primitives, GLuint buffer, GLintptr offset, GLsizeiptr size);
    void end();

    /** Draw what was captured last, without asking how much that is. */
    void draw(GLenum primitives) const;

    /** Wait for the last capture to be over, and count. */
    CapturedPrimitives getResult() const;

private:
    const osg::GLExtensions& _extensions;
    GLuint _name = 0;
    GLuint _queries[2] = {0, 0};
};

} // namespace osgLego
