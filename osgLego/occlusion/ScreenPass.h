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

/** Runs a program for every pixel of a picture, by drawing one triangle that covers the picture.
 *
 * Input textures get the texture units 0, 1, ... in the given order. Also sets the uniforms of the scene declared in
 * shaders/occlusion/view_position.glsl and shaders/light/ambient_light.glsl. Used by one cull visitor.
 */
class ScreenPass : public osg::Drawable
{
public:
    /** After cameras that draw textures for the scene. */
    static constexpr int RENDER_ORDER = 1000;

    struct Input
    {
        const char* name;
        osg::ref_ptr<osg::Texture> texture;
    };

    ScreenPass(osg::Program& program, const std::vector<Input>& inputs);

    /** Draw before the frame into textures, which are first cleared to `clearColor`. Without targets, the pass draws
     * into the frame itself. */
    void setTargets(const std::vector<osg::ref_ptr<osg::Texture2D>>& targets, const osg::Vec4& clearColor);

    /** The node for a cull visitor: the camera or, for a pass without targets, the drawable itself. */
    osg::Node& getNode();

    /** Set the scene's projection, whose near and far planes may still change before drawing; the rotation from eye
     * coordinates to world coordinates; and the lower left corner and size of the picture in the frame, in pixels. */
    void setView(const osg::RefMatrix& projection, const osg::Matrixd& eyeToWorld, const glm::ivec2& origin,
                 const glm::ivec2& size);

    /** Skip this pass if the given stage could not draw. */
    void setSource(const GeometryBufferStage& source) { _source = &source; }

    /** Wait for the GPU after drawing, so that getTime() can return a time. */
    void setTiming(bool timing) { _timing = timing; }
    /** The duration of the last drawing, in milliseconds; 0 without setTiming(). */
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
