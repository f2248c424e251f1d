#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <osg/Camera>
#include <osg/Drawable>
#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The camera of a pass: draws the pass's only drawable into a frame buffer object, before the frame.
 *
 * The drawable owns the camera, not the other way round: a frame being drawn holds references to its drawables, and so
 * keeps the camera alive even if the node has been removed meanwhile.
 */
class PassCamera : public osg::Camera
{
public:
    /** Draw into a texture, after clearing it to `clearColor`. */
    PassCamera(const osg::Drawable& drawable, osg::Texture2D& target, const osg::Vec4& clearColor);
    /** Draw into several textures of the same size: gl_FragData[0] into the first, and so on. */
    PassCamera(const osg::Drawable& drawable, const std::vector<osg::ref_ptr<osg::Texture2D>>& targets,
               const osg::Vec4& clearColor);
    /** Draw into no texture: for transform feedback, which still needs a complete frame buffer. */
    explicit PassCamera(const osg::Drawable& drawable);

    /** Add a depth buffer of 24 bits, cleared to the far plane. The pass itself enables the depth test. */
    void addDepthBuffer();
    /** The same, kept in a texture of createDepthTarget(), which several cameras may share. */
    void addDepthBuffer(osg::Texture2D& target);

    void traverse(osg::NodeVisitor& visitor) override;

    /** A texture for a pass to draw into: RGBA, unfiltered, stored as `internalFormat`. */
    static osg::ref_ptr<osg::Texture2D> createTarget(const glm::ivec2& size, GLint internalFormat);
    /** A texture for addDepthBuffer(). */
    static osg::ref_ptr<osg::Texture2D> createDepthTarget(const glm::ivec2& size);

private:
    ~PassCamera() override = default;

    static osg::ref_ptr<osg::Texture2D> createTexture(const glm::ivec2& size, GLint internalFormat, GLenum format);

    void setUp(const glm::ivec2& size);
    void clearDepthBuffer();

    const osg::Drawable& _drawable;
};

} // namespace osgLego
