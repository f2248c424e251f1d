#pragma once

#include <osgLego/gl/PassCamera.h>
#include <osgLego/occlusion/GeometryBufferStage.h>

#include <atomic>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <osg/Drawable>
#include <osg/Matrixd>
#include <osg/Texture>
#include <osg/ref_ptr>

namespace osgLego
{

/** A program run over every pixel of a picture: one triangle that covers it.
 *
 * Reads textures by texture unit, in the order in which they are given, and what shaders/occlusion/view_position.glsl
 * and shaders/light/ambient_light.glsl say of the scene. Used by one cull visitor.
 */
class ScreenPass : public osg::Drawable
{
public:
    /** Behind cameras whose textures the scene may use. */
    static constexpr int RENDER_ORDER = 1000;

    struct Input
    {
        const char* name;
        osg::ref_ptr<osg::Texture> texture;
    };

    ScreenPass(osg::Program& program, const std::vector<Input>& inputs);

    /** Draw into textures, cleared before to `clearColor`, ahead of the frame. Without this, into the frame itself. */
    void setTargets(const std::vector<osg::ref_ptr<osg::Texture2D>>& targets, const osg::Vec4& clearColor);

    /** Give this to a cull visitor: the camera, or, of a pass without targets, the drawable itself. */
    osg::Node& getNode();

    /** The scene's projection, whose near and far planes may still change until it is drawn, the turn from the eye's
     * coordinates to the world's, and where its picture is in the frame, in pixels. */
    void setView(const osg::RefMatrix& projection, const osg::Matrixd& eyeToWorld, const glm::ivec2& origin,
                 const glm::ivec2& size);

    /** Draw only what a stage has drawn. */
    void setSource(const GeometryBufferStage& source) { _source = &source; }

    /** Wait after drawing, and have getTime(). */
    void setTiming(bool timing) { _timing = timing; }
    /** The milliseconds that it took when it was drawn last; 0 without timing. */
    double getTime() const { return _time; }

    osg::BoundingBox computeBoundingBox() const override { return {}; }
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "ScreenPass"; }

private:
    ~ScreenPass() override = default;

    osg::ref_ptr<PassCamera> _camera;
    osg::ref_ptr<const GeometryBufferStage> _source;
    osg::ref_ptr<const osg::RefMatrix> _projection;
    glm::mat3 _eyeToWorld{1.0f};
    glm::ivec2 _origin{0};
    glm::ivec2 _size{1};
    bool _timing = false;
    mutable std::atomic<double> _time{0.0};
};

} // namespace osgLego
