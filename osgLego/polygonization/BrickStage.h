#pragma once

#include <osg/Matrixd>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

namespace osgLego
{

/** A render stage in which bricks draw into a geometry buffer (shaders/polygonization/geometry_buffer.glsl) and not
 * into the frame; by its type bricks know that they are drawn in one.
 */
class BrickStage : public osgUtil::RenderStage
{
public:
    /** The stage that a visitor is filling, if it is one of this kind; else null. */
    static BrickStage* find(osgUtil::CullVisitor& visitor)
    {
        return dynamic_cast<BrickStage*>(visitor.getCurrentRenderBin()->getStage());
    }

    /** Say that bricks are drawn in this frame, how wide they are in their own coordinates, and the transform from
     * these to the eye's. */
    virtual void noteBricks(double pitch, const osg::Matrixd& modelView) = 0;

protected:
    ~BrickStage() override = default;
};

} // namespace osgLego
