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

    /** Let lights and clip planes of the stage around act in this one as they do there: those that it inherits from
     * stages around it, as one that renders to a texture does, too. */
    void inheritPositionalState(osgUtil::RenderStage& outer);

    /** Have cameras among the children that draw after the frame do so after the frame around. */
    void handOnPostRenderStages(osgUtil::RenderStage& outer);

    void noteBricks(double pitch, const osg::Matrixd& modelView) override;
    /** How wide the widest bricks of this frame are, in the eye's coordinates; 0 when there are none. */
    double getPitch() const { return _pitch; }

    /** Wait after drawing, and have getTime(). */
    void setTiming(bool timing);
    /** The milliseconds that drawing the children took last; 0 without timing. */
    double getTime() const;

    /** Whether there was no memory on the GPU for the buffer when it was to be drawn into, and nothing was drawn. */
    bool hasFailed() const;

    osg::Object* cloneType() const override { return new GeometryBufferStage; }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "GeometryBufferStage"; }

protected:
    ~GeometryBufferStage() override;

private:
    class Draw;

    osg::ref_ptr<Draw> _draw;
    double _pitch = 0.0;
};

} // namespace osgLego
