#pragma once

#include <osgLego/gl/PassCamera.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/occlusion/GeometryBufferStage.h>
#include <osgLego/occlusion/PictureArea.h>

#include <atomic>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <osg/BoundingSphere>
#include <osg/Drawable>
#include <osg/Matrixd>
#include <osg/Texture>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** A picture that is computed in passes, as a camera sees it. */
struct PassView
{
    osg::ref_ptr<const osg::RefMatrix> projection; //!< its near and far planes may still change before drawing
    glm::mat3 eyeToWorld{1.0f};                    //!< a rotation
    glm::ivec2 origin{0};                          //!< the lower left pixel of the picture in the frame
    glm::ivec2 size{1};                            //!< pixels
    PictureArea area;                              //!< the part of the picture that may show something
    osg::BoundingSphere bound;                     //!< of the scene, in model coordinates
};

/** Runs a program for every pixel of a part of a picture.
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
     * into the frame itself.
     * @param pixelsPerTexel of the picture, along both axes. */
    void setTargets(const std::vector<osg::ref_ptr<osg::Texture2D>>& targets, const osg::Vec4& clearColor,
                    int pixelsPerTexel = 1);

    /** Draw only the tiles for which a texture is above 0, instead of the whole area. Tiles are squares of
     * PictureTiles::SIDE pixels. The program must have the vertex shader screen_tiles.vert instead of screen.vert. */
    void setTiles(osg::Texture2D& tiles);

    void setView(const PassView& view);
    /** Cull the camera or, for a pass without targets, the drawable itself. */
    void cull(osgUtil::CullVisitor& visitor);

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

    osg::Node& getNode();
    void draw(const ProgramUniforms& uniforms) const;

    osg::ref_ptr<PassCamera> _camera;
    osg::ref_ptr<const GeometryBufferStage> _source;
    int _pixelsPerTexel = 1;
    bool _drawsTiles = false;
    PassView _view;
    osg::BoundingSphere _bound; // of the drawable
    bool _timing = false;
    mutable std::atomic<double> _time{0.0};
};

} // namespace osgLego
