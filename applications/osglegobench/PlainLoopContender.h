#pragma once

#include "BrickPointBuffer.h"
#include "Contender.h"
#include "StageTimes.h"

#include <cstdint>
#include <vector>

namespace osgLego
{

/** What anyone would write first: for every triangle, every cell of its bounds by the published test (overlapsBox),
 * into an array of all cells; then a loop over that for points. One thread, no colours, nothing clever. */
class PlainLoopContender : public Contender, public StageTimes
{
public:
    std::string getName() const override { return "plain loop"; }
    bool hasColors() const override { return false; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() override;
    osg::ref_ptr<const BrickModel> getBricks() override;
    void release() override;
    std::vector<std::pair<std::string, double>> getStageTimes() const override;

private:
    std::size_t numberOf(const glm::ivec3& cell) const;
    void cover(const GridVertex* corners);
    std::uint8_t findOpenSides(const glm::ivec3& cell) const;
    std::vector<BrickPoint> createPoints() const;

    osg::ref_ptr<const GridTriangles> _triangles;
    glm::ivec3 _dimensions{0};
    std::vector<std::uint8_t> _cells; // 1: covered
    BrickPointBuffer _buffer;
    double _coverage = 0.0;
    double _points = 0.0;
};

} // namespace osgLego
