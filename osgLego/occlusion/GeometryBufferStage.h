#pragma once

#include <osgLego/polygonization/BrickStage.h>

#include <osg/Matrixd>
#include <osg/ref_ptr>

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

    osg::Object* cloneType() const override { return new GeometryBufferStage; }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "GeometryBufferStage"; }

protected:
    ~GeometryBufferStage() override;

private:
    class Draw;

    osg::ref_ptr<Draw> _draw;
    bool _hasDistantOcclusion = false;
    double _pitch = 0.0;
};

} // namespace osgLego
