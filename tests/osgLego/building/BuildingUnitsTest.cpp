#include <osgLego/building/BuildingUnits.h>

#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(BuildingUnits, PartsThatHangFromAPartInPlaceAreAUnitWithoutIt)
{
    // A beam on a column, and a brick below the end of the beam.
    const JointGraph graph({{{0, 0, 2}, {8, 2, 3}}, {{0, 0, 0}, {2, 2, 2}}, {{6, 0, 1}, {8, 2, 2}}});
    BuildingUnits units(graph);
    units.group({true, true, false}, {false, false, false});
    ASSERT_EQ(units.getUnits().size(), 1u);
    EXPECT_EQ(units.getUnits()[0].parts, std::vector<std::uint32_t>{2});
    EXPECT_EQ(units.getUnitOf(0), BuildingUnits::NONE);
    EXPECT_EQ(units.getUnitOf(2), 0u);
}

TEST(BuildingUnits, PartsThatHangFromSeveralPartsHangFromOneThatIsNotInPlace)
{
    // A brick below the ends of two beams, of which one, with more studs on the brick, is in place.
    const JointGraph graph({{{0, 0, 2}, {9, 2, 3}},
                            {{0, 0, 0}, {2, 2, 2}},
                            {{7, 0, 1}, {10, 2, 2}},
                            {{9, 0, 2}, {16, 2, 3}},
                            {{14, 0, 0}, {16, 2, 2}}});
    BuildingUnits units(graph);
    units.group({true, true, false, false, false}, std::vector<bool>(5, false));
    ASSERT_EQ(units.getUnits().size(), 2u);
    EXPECT_EQ(units.getUnits()[units.getUnitOf(2)].parts, (std::vector<std::uint32_t>{3, 2}));
}

TEST(BuildingUnits, PartsHangFromTheNearestOfPartsWithEquallyManyStuds)
{
    // A brick below two beams on columns. The middle of one beam is nearer along one axis, and farther away altogether.
    for (const bool hasAxesExchanged : {false, true})
    {
        std::vector<BuildingBox> boxes{{{0, 0, 1}, {4, 2, 2}},
                                       {{0, 0, 2}, {2, 8, 3}},
                                       {{2, 0, 2}, {6, 2, 3}},
                                       {{0, 6, 0}, {2, 8, 2}},
                                       {{4, 0, 0}, {6, 2, 2}}};
        if (hasAxesExchanged)
            for (BuildingBox& box : boxes)
                for (glm::ivec3* corner : {&box.lower, &box.upper})
                    std::swap(corner->x, corner->y);
        const JointGraph graph(boxes);
        BuildingUnits units(graph);
        units.group(std::vector<bool>(5, false), std::vector<bool>(5, false));
        EXPECT_EQ(units.getUnits()[units.getUnitOf(0)].parts, (std::vector<std::uint32_t>{2, 0}));
    }
}

TEST(BuildingUnits, PartsHangFromThePartWithMoreStudsThoughItIsFarther)
{
    // A brick below two beams on columns: two studs hold it from the near beam, and six from the far one.
    const JointGraph graph({{{0, 0, 1}, {4, 2, 2}},
                            {{3, 0, 2}, {5, 2, 3}},
                            {{0, 0, 2}, {3, 8, 3}},
                            {{4, 0, 0}, {5, 2, 2}},
                            {{0, 6, 0}, {2, 8, 2}}});
    BuildingUnits units(graph);
    units.group(std::vector<bool>(5, false), std::vector<bool>(5, false));
    EXPECT_EQ(units.getUnits()[units.getUnitOf(0)].parts, (std::vector<std::uint32_t>{2, 0}));
}

TEST(BuildingUnits, PartsHangFromTheLowerOfPartsThatAreEquallyGood)
{
    // Two hanging bricks upon each other. Above each is a beam with four studs on it, equally far from their middle.
    const JointGraph graph({{{4, 0, 1}, {8, 2, 2}},
                            {{4, 0, 2}, {6, 2, 3}},
                            {{6, 0, 2}, {10, 2, 3}},
                            {{4, 0, 3}, {12, 2, 4}},
                            {{8, 0, 0}, {10, 2, 2}}});
    BuildingUnits units(graph);
    units.group(std::vector<bool>(5, false), std::vector<bool>(5, false));
    EXPECT_EQ(units.getUnits()[units.getUnitOf(0)].parts, (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(BuildingUnits, OnlyPartsThatMustBePlacedBeforeEachOtherBecomeOneUnit)
{
    // On a column lies a beam, on its end a second beam, and on that one a brick. Below the end of the first beam hangs
    // a brick, and below that brick, without contact, an angle that hangs from the second beam.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 4}},
                            {{0, 0, 4}, {8, 2, 5}},
                            {{6, 0, 3}, {8, 2, 4}},
                            {{4, 0, 5}, {11, 2, 6}},
                            {{9, 0, 2}, {11, 2, 5}},
                            {{6, 0, 1}, {11, 2, 2}},
                            {{4, 0, 6}, {6, 2, 7}}});
    BuildingUnits units(graph);
    units.group(std::vector<bool>(7, false), std::vector<bool>(7, false));
    ASSERT_EQ(units.getUnits().size(), 3u);
    EXPECT_EQ(units.getUnits()[units.getUnitOf(0)].parts, std::vector<std::uint32_t>{0});
    EXPECT_EQ(units.getUnits()[units.getUnitOf(1)].parts, (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(units.getUnits()[units.getUnitOf(6)].parts, std::vector<std::uint32_t>{6});
}

} // namespace

} // namespace osgLego::test
