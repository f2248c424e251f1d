#include "BookletModels.h"

#include <booklet/TableGrid.h>

#include <PartModels.h>

#include <osg/BoundingBox>
#include <osg/ComputeBoundsVisitor>
#include <osg/Geode>
#include <osg/Geometry>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double HEIGHT = 1.2;

/** Two bricks on the table, 3x2 and 1x1, with 4 studs between them, and one high above. */
const std::vector<Part> PARTS{
    {{2, 1, 1}, {3, 2, 1}, RED, 4}, {{9, 1, 1}, {1, 1, 1}, RED, 4}, {{0, 0, 5}, {20, 1, 1}, RED, 4}};

osg::BoundingBox measure(osg::Node& node)
{
    osg::ComputeBoundsVisitor visitor;
    node.accept(visitor);
    return visitor.getBoundingBox();
}

} // namespace

TEST(TableGrid, HasALineBetweenTheStudsOfPartsOnTheTableAndOneStudMore)
{
    const osg::ref_ptr<osg::Node> grid = createTableGrid(createPartGrid({20, 5, 8}, HEIGHT), PARTS, false);
    const osg::BoundingBox box = measure(*grid);
    EXPECT_EQ(box._min, osg::Vec3(1, 0, static_cast<float>(HEIGHT)));
    EXPECT_EQ(box._max, osg::Vec3(11, 4, static_cast<float>(HEIGHT)));
    const unsigned int numLinesAcross = 11;
    const unsigned int numLinesAlong = 5;
    EXPECT_EQ(grid->asGeode()->getDrawable(0)->asGeometry()->getVertexArray()->getNumElements(),
              2 * (numLinesAcross + numLinesAlong));
}

TEST(TableGrid, UpsideDownIsAtTheTopOfTheHighestPart)
{
    const osg::ref_ptr<osg::Node> grid = createTableGrid(createPartGrid({20, 5, 8}, HEIGHT), PARTS, true);
    const osg::BoundingBox box = measure(*grid);
    EXPECT_EQ(box._min, osg::Vec3(-1, -1, static_cast<float>(6.0 * HEIGHT)));
    EXPECT_EQ(box._max, osg::Vec3(21, 2, static_cast<float>(6.0 * HEIGHT)));
}

TEST(TableGrid, LiesInThePlaneOfTheGroundIfYIsUp)
{
    BrickGrid grid = createPartGrid({20, 8, 5}, HEIGHT);
    grid.upAxis = UpAxis::Y;
    grid.cellSize = {1.0, HEIGHT, 1.0};
    grid.origin = {0.5, 0.25, 0.0};
    const std::vector<Part> parts{{{2, 1, 1}, {3, 1, 2}, RED, 4}};
    const osg::BoundingBox box = measure(*createTableGrid(grid, parts, false));
    EXPECT_EQ(box._min, osg::Vec3(1.5f, static_cast<float>(0.25 + HEIGHT), 0));
    EXPECT_EQ(box._max, osg::Vec3(6.5f, static_cast<float>(0.25 + HEIGHT), 4));
}

} // namespace osgLego::test
