#pragma once

#include "NativeContender.h"

#include <cstdint>
#include <vector>

namespace osgLego
{

/** The obvious method: tests every triangle with every cell of its bounds by the published test, marks covered cells in
 * an array of all cells, and loops over this array to create the points. One thread, no colours, no optimization. */
class PlainLoopContender : public NativeContender
{
public:
    std::string getName() const override { return "plain loop"; }
    bool hasColors() const override { return false; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    osg::ref_ptr<const BrickModel> getBricks() override;
    void release() override;

protected:
    osg::ref_ptr<const BrickModel> findCells() override;
    std::vector<BrickPoint> createPoints() override;

private:
    std::size_t numberOf(const glm::ivec3& cell) const;
    void cover(const GridVertex* corners);
    std::uint8_t findOpenSides(const glm::ivec3& cell) const;
    /** Call a function with every covered cell, as a grey brick. */
    template <typename Function>
    void visitBricks(const Function& function) const;

    glm::ivec3 _dimensions{0};
    std::vector<std::uint8_t> _cells; // 1: covered
};

} // namespace osgLego
