#pragma once

#include "Contender.h"

#include <osgLego/data/BrickPoints.h>
#include <osgLego/gl/GlObject.h>

namespace osgLego
{

/** The base class of contenders that find bricks without GL. They produce the same result as those on the GPU: points
 * in a GL buffer. */
class NativeContender : public Contender
{
public:
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() final;
    Stages getStages() const final { return {{"cells", _cellsTime}, {"points", _pointsTime}}; }
    osg::ref_ptr<const BrickModel> getBricks() override { return _bricks; }
    void release() override;

protected:
    /** Find the covered cells.
     * @return the cells as bricks; null if createPoints() does not need them. */
    virtual osg::ref_ptr<const BrickModel> findCells() = 0;
    /** Create the points of the visible bricks among these cells. */
    virtual std::vector<BrickPoint> createPoints() { return createBrickPoints(*_bricks).points; }

    const GridTriangles& getTriangles() const { return *_triangles; }

private:
    osg::ref_ptr<const GridTriangles> _triangles;
    osg::ref_ptr<const BrickModel> _bricks;
    osg::ref_ptr<osg::GraphicsContext> _context;
    GlBuffer _buffer;
    double _cellsTime = 0.0;
    double _pointsTime = 0.0;
};

} // namespace osgLego
