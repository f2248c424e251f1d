#pragma once

#include <osg/GL>
#include <osg/GLExtensions>

namespace osgLego
{

/** The number of primitives that a transform feedback generated, and the number that fitted into its buffer. */
struct CapturedPrimitives
{
    GLuint generated = 0;
    GLuint written = 0;

    bool isComplete() const { return generated == written; }
};

/** A GL transform feedback object, with two queries that determine whether its buffer was large enough.
 *
 * Rasterization is off while capturing. All functions, including constructor and destructor, need the context current
 * in which the object was made; contexts do not share transform feedback objects (OpenGL 4.6, chapter 5).
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

    /** Draw the primitives of the last capture, without reading their number back. */
    void draw(GLenum primitives) const;

    /** Wait for the last capture to finish, and count its primitives. */
    CapturedPrimitives getResult() const;

private:
    const osg::GLExtensions& _extensions;
    GLuint _name = 0;
    GLuint _queries[2] = {0, 0};
};

} // namespace osgLego
