#include <LookTest.h>
#include <PartModels.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace osgLego::test
{

namespace
{

// Cells along each side of the wall that WALL_VIEW shows.
constexpr int SIDE = 20;

// The cells that are completely in the picture.
constexpr int FIRST_COLUMN = 4;
constexpr int LAST_COLUMN = 15;
constexpr int FIRST_ROW = 5;
constexpr int LAST_ROW = 14;

/** The left or lower end of a cell in the picture, in pixels. */
int beginOf(int cell, int size)
{
    return size / 2 + WALL_PIXELS * (cell - SIDE / 2);
}

/** The brightness at the centre of a cell of the wall. */
double centerOf(const osg::Image& image, int x, int z)
{
    return brightnessAt(image, beginOf(x, image.s()) + WALL_PIXELS / 2, beginOf(z, image.t()) + WALL_PIXELS / 2);
}

/** The darkest pixel at the border between a cell and the next one to the right or above. */
double borderOf(const osg::Image& image, int x, int z, bool isUpper)
{
    const int column = beginOf(x, image.s()) + (isUpper ? WALL_PIXELS / 2 : WALL_PIXELS);
    const int row = beginOf(z, image.t()) + (isUpper ? WALL_PIXELS : WALL_PIXELS / 2);
    return std::min(brightnessAt(image, column, row),
                    brightnessAt(image, isUpper ? column : column - 1, isUpper ? row - 1 : row));
}

template <typename Visit>
void forEachCell(const Visit& visit)
{
    for (int z = FIRST_ROW; z < LAST_ROW; ++z)
        for (int x = FIRST_COLUMN; x < LAST_COLUMN; ++x)
            visit(x, z);
}

/** Pictures of parts of one colour. */
class PartLook : public LookTest
{
protected:
    static osg::ref_ptr<const BrickModel> createWall(int side = SIDE)
    {
        PartFilling filling;
        filling.heights = {1, 3};
        return createParts(createPartGrid({side, 1, side}), filling);
    }

    /** A picture of the wall, through an AmbientOcclusionScene or without it. */
    osg::ref_ptr<osg::Image> drawWall(const BrickModel& wall, const BrickAppearance& appearance,
                                      const std::string& settings, bool isOccluded)
    {
        const osg::ref_ptr<LegoNode> node = createStoredNode(wall, settings);
        EXPECT_TRUE(node->setAppearance(appearance));
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", node);
        group->setEnabled(isOccluded);
        return draw(*group, WALL_VIEW);
    }
};

TEST_F(PartLook, JointsAreBetweenPartsAndNoneIsInsideAPart)
{
    const osg::ref_ptr<const BrickModel> wall = createWall();
    BrickAppearance appearance;
    appearance.variation = 0.0;
    for (const char* settings : {"20,drawing=triangles", "20,drawing=splats", "20,device=gpu"})
        for (const bool isOccluded : {false, true})
        {
            SCOPED_TRACE(settings);
            const osg::ref_ptr<osg::Image> image = drawWall(*wall, appearance, settings, isOccluded);
            int numJoints = 0;
            int numInside = 0;
            forEachCell(
                [&](int x, int z)
                {
                    for (const bool isUpper : {false, true})
                    {
                        const Part* next = isUpper ? wall->findPart({x, 0, z + 1}) : wall->findPart({x + 1, 0, z});
                        const double face = centerOf(*image, x, z);
                        const double border = borderOf(*image, x, z, isUpper);
                        if (wall->findPart({x, 0, z}) == next)
                        {
                            EXPECT_GT(border, 0.985 * face) << x << " " << z << " " << isUpper << ", inside a part";
                            ++numInside;
                        }
                        else
                        {
                            EXPECT_LT(border, 0.97 * face) << x << " " << z << " " << isUpper << ", between parts";
                            ++numJoints;
                        }
                    }
                });
            EXPECT_GT(numJoints, 30);
            EXPECT_GT(numInside, 30);
        }
}

TEST_F(PartLook, VariationIsThatOfThePart)
{
    const osg::ref_ptr<const BrickModel> wall = createWall();
    for (const char* settings : {"20,drawing=triangles", "20,drawing=splats"})
    {
        SCOPED_TRACE(settings);
        BrickAppearance appearance;
        appearance.joints = false;
        appearance.variation = 0.0;
        const osg::ref_ptr<osg::Image> plain = drawWall(*wall, appearance, settings, false);
        appearance.variation = 2.0;
        const osg::ref_ptr<osg::Image> varied = drawWall(*wall, appearance, settings, false);
        const auto variationOf = [&](int x, int z) { return centerOf(*varied, x, z) / centerOf(*plain, x, z); };
        double differences = 0.0;
        int numDifferent = 0;
        forEachCell(
            [&](int x, int z)
            {
                for (const glm::ivec3& next : {glm::ivec3(x + 1, 0, z), glm::ivec3(x, 0, z + 1)})
                {
                    const double difference = std::abs(variationOf(x, z) - variationOf(next.x, next.z));
                    if (wall->findPart({x, 0, z}) == wall->findPart(next))
                        EXPECT_LT(difference, 0.009) << x << " " << z; // 1 of 255 in either picture
                    else
                        differences += difference, ++numDifferent;
                }
            });
        EXPECT_GT(differences / numDifferent, 0.02);
    }
}

TEST_F(PartLook, OnlyTheLookDependsOnParts)
{
    // The plain look has no joints and no variation.
    const osg::ref_ptr<const BrickModel> parts = createWall();
    const osg::ref_ptr<const BrickModel> cells = createCells(*parts);
    for (const char* settings : {"20,look=plain,drawing=triangles", "20,look=plain,drawing=splats"})
        EXPECT_EQ(countDifferent(*draw(*createStoredNode(*parts, settings), WALL_VIEW),
                                 *draw(*createStoredNode(*cells, settings), WALL_VIEW), 0),
                  0u)
            << settings;
    const char* full = "20,drawing=triangles";
    EXPECT_GT(countDifferent(*draw(*createStoredNode(*parts, full), WALL_VIEW),
                             *draw(*createStoredNode(*cells, full), WALL_VIEW), 4),
              1000u);
}

/** A wall of equal parts, as wide and as high as 240 cells. */
osg::ref_ptr<const BrickModel> createWallOf(const glm::ivec3& size)
{
    constexpr int LENGTH = 240;
    std::vector<Part> parts;
    for (int z = 0; z < LENGTH; z += size.z)
        for (int x = 0; x < LENGTH; x += size.x)
        {
            Part part;
            part.cell = {static_cast<std::uint16_t>(x), 0, static_cast<std::uint16_t>(z)};
            part.size = {static_cast<std::uint8_t>(size.x), 1, static_cast<std::uint8_t>(size.z)};
            part.color = {150, 150, 150};
            parts.push_back(part);
        }
    return BrickModel::createOfParts(createPartGrid({LENGTH, 1, LENGTH}), parts);
}

TEST_F(PartLook, FromAfarLargePartsAreBrighterThanSmallOnesAsMuchAsFromNearby)
{
    // Large parts have fewer joints, which are dark; from afar, only their mean is drawn.
    BrickAppearance appearance;
    appearance.variation = 0.0;
    const auto meanAt = [&](const glm::ivec3& size, double pixelsPerCell)
    {
        const osg::ref_ptr<LegoNode> node = createStoredNode(*createWallOf(size), "240");
        node->setAppearance(appearance);
        return meanBrightness(*draw(*node, {{120, -400, 120}, {120, 0, 120}, {0, 0, 1}, HEIGHT / pixelsPerCell}));
    };
    constexpr double NEAR = 12.5;
    const glm::ivec3 small(1, 1, 1);
    const double nearby = meanAt(small, NEAR);
    for (const double far : {0.9, 1.5})
    {
        const double distant = meanAt(small, far);
        for (const glm::ivec3& size :
             {glm::ivec3(2, 1, 1), glm::ivec3(4, 1, 1), glm::ivec3(3, 1, 3), glm::ivec3(8, 1, 3)})
            EXPECT_NEAR(meanAt(size, far) / distant, meanAt(size, NEAR) / nearby, 0.006)
                << size.x << "x" << size.z << " at " << far << " pixels a cell";
    }
    EXPECT_GT(meanAt({8, 1, 3}, NEAR) / nearby, 1.02);
}

TEST_F(PartLook, PartsSmallerThanAPixelDoNotSparkle)
{
    // 300 x 300 cells, each of 0.7 pixels.
    const osg::ref_ptr<LegoNode> node = createStoredNode(*createWall(300), "300");
    for (const bool isOccluded : {false, true})
    {
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", node);
        group->setEnabled(isOccluded);
        const osg::ref_ptr<osg::Image> image = draw(*group, {{150, -400, 150}, {150, 0, 150}, {0, 0, 1}, HEIGHT / 0.7});
        EXPECT_LT(stepBetweenPixels(*image), 1.5 / 255.0) << isOccluded;
    }
}

} // namespace

} // namespace osgLego::test
