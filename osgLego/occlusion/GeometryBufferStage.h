#pragma once

#include <osgLego/polygonization/BrickStage.h>

#include <functional>

#include <osg/Matrixd>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The stage in which an AmbientOcclusionScene draws its children.
 *
 * Used by one cull visitor.
 */
class GeometryBufferStage : public BrickStage
{
public:
    GeometryBufferStage();

    void reset() override;
    /** Reset it for the next frame, in which it shares the lights and clip planes of the outer stage: those outside
     * apply to the children, and those of the children to nodes outside. Techniques of osgShadow look for them there.
     */
    void resetFor(osgUtil::RenderStage& outer);

    /** Let a visitor fill this stage, and then go on with its present one. Techniques of osgShadow look in the
     * visitor's stage for receivers of shadows and for the camera. An osg::ClearNode among the children changes the
     * present stage.
     * @param cullChildren traverses the children with the visitor. */
    void cull(osgUtil::CullVisitor& visitor, const std::function<void()>& cullChildren);

    /** Move the POST_RENDER cameras among the children to the outer stage, so that they are drawn after it. */
    void handOnPostRenderStages(osgUtil::RenderStage& outer);

    void setDistantOcclusion(bool isOn) { _hasDistantOcclusion = isOn; }
    bool hasDistantOcclusion() const override { return _hasDistantOcclusion; }
    void noteBricks(double pitch, const osg::Matrixd& modelView) override;
    /** The width of the widest bricks in this frame, in eye coordinates; 0 if there are none. */
    double getPitch() const { return _pitch; }

    /** Wait for the GPU after drawing, so that getTime() can return a time. */
    void setTiming(bool timing);
    /** The time it took to draw the children in the last frame, in milliseconds; 0 without setTiming(). */
    double getTime() const;

    /** Whether the GPU had too little memory for the buffer, so that nothing was drawn. */
    bool hasFailed() const;

    /** While it is filled, a stage like the visitor's before: CullVisitor creates the stages of cameras by copying. */
    osg::Object* cloneType() const override { return _root ? _root->cloneType() : new GeometryBufferStage; }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "GeometryBufferStage"; }

protected:
    ~GeometryBufferStage() override;

private:
    class Draw;

    osg::ref_ptr<Draw> _draw;
    osg::ref_ptr<osgUtil::RenderStage> _root; // that of the visitor that is filling this stage
    bool _hasDistantOcclusion = false;
    double _pitch = 0.0;
};

} // namespace osgLego
