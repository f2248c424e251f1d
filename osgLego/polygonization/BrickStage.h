#pragma once

#include <osg/Matrixd>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

namespace osgLego
{

/** A render stage in which bricks are drawn into a geometry buffer (shaders/polygonization/geometry_buffer.glsl)
 * instead of the frame. Bricks recognize it by its type.
 */
class BrickStage : public osgUtil::RenderStage
{
public:
    /** The stage that a visitor is filling if it is a BrickStage, otherwise null. */
    static BrickStage* find(osgUtil::CullVisitor& visitor)
    {
        return dynamic_cast<BrickStage*>(visitor.getCurrentRenderBin()->getStage());
    }

    /** Whether distant bricks may occlude bricks. */
    virtual bool hasDistantOcclusion() const = 0;

    /** Record that bricks are drawn in this frame.
     * @param pitch their width in model coordinates.
     * @param modelView transforms model coordinates to eye coordinates. */
    virtual void noteBricks(double pitch, const osg::Matrixd& modelView) = 0;

protected:
    ~BrickStage() override = default;
};

} // namespace osgLego
