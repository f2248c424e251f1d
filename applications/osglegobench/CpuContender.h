#pragma once

#include "BrickPointBuffer.h"
#include "Contender.h"
#include "StageTimes.h"

namespace osgLego
{

/** This project's own way without GL, legolizeOnCpu, and its bricks brought to the renderer. */
class CpuContender : public Contender, public StageTimes
{
public:
    std::string getName() const override { return "exact, cpu"; }
    bool hasColors() const override { return true; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() override;
    osg::ref_ptr<const BrickModel> getBricks() override { return _bricks; }
    void release() override;
    std::vector<std::pair<std::string, double>> getStageTimes() const override;

private:
    osg::ref_ptr<const GridTriangles> _triangles;
    osg::ref_ptr<const BrickModel> _bricks;
    BrickPointBuffer _buffer;
    double _legolization = 0.0;
    double _points = 0.0;
};

} // namespace osgLego
