#include <osgLego/building/Symmetry.h>

#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Boxes with x and y exchanged. */
std::vector<BuildingBox> exchangeAxes(std::vector<BuildingBox> boxes)
{
    for (BuildingBox& box : boxes)
        for (glm::ivec3* corner : {&box.lower, &box.upper})
            std::swap(corner->x, corner->y);
    return boxes;
}

/** Three pairs of parts that mirror each other across x, one part that mirrors itself, and one cell without a twin. */
std::vector<BuildingBox> createPairs()
{
    return {{{3, 0, 0}, {5, 8, 1}},  {{11, 0, 0}, {13, 8, 1}}, {{3, 2, 1}, {7, 4, 2}}, {{9, 2, 1}, {13, 4, 2}},
            {{4, 1, 2}, {12, 2, 3}}, {{5, 1, 3}, {6, 3, 4}},   {{3, 5, 1}, {4, 6, 2}}, {{10, 1, 3}, {11, 3, 4}}};
}

TEST(Symmetry, FindsTheTwinsOfPartsAcrossEitherAxis)
{
    constexpr std::uint32_t NONE = Symmetry::NONE;
    for (const auto& boxes : {createPairs(), exchangeAxes(createPairs())})
    {
        const Symmetry symmetry(boxes);
        ASSERT_TRUE(symmetry.hasPlane());
        const std::vector<std::uint32_t> twins{1, 0, 3, 2, NONE, 7, NONE, 5};
        for (std::uint32_t part = 0; part < boxes.size(); ++part)
            EXPECT_EQ(symmetry.getTwin(part), twins[part]) << part;
    }
}

TEST(Symmetry, FoldsPlacesAboutThePlaneOfEitherAxis)
{
    // The plane is at x = 8, which are 16 half cells.
    const Symmetry across(createPairs());
    EXPECT_EQ(across.fold({16, 5, 3}), glm::ivec3(0, 5, 3));
    EXPECT_EQ(across.fold({19, 5, 3}), across.fold({13, 5, 3}));
    EXPECT_NE(across.fold({19, 5, 3}), across.fold({14, 5, 3}));
    const Symmetry along(exchangeAxes(createPairs()));
    EXPECT_EQ(along.fold({5, 16, 3}), glm::ivec3(5, 0, 3));
    EXPECT_EQ(along.fold({5, 19, 3}), along.fold({5, 13, 3}));
    EXPECT_EQ(along.mirror({{1, 3, 0}, {2, 7, 1}}), (BuildingBox{{1, 9, 0}, {2, 13, 1}}));
}

TEST(Symmetry, NeedsATwinForNineTenthsOfTheCells)
{
    const auto hasPlane = [](int length) // of a row, beside whose first cell there is another one
    {
        return Symmetry({{{0, 0, 0}, {length, 1, 1}}, {{0, 1, 0}, {1, 2, 1}}}).hasPlane();
    };
    EXPECT_TRUE(hasPlane(9)) << "nine of ten cells";
    EXPECT_FALSE(hasPlane(8)) << "eight of nine cells";
    EXPECT_FALSE(Symmetry({}).hasPlane());
}

TEST(Symmetry, OfTwoPlanesThatFitEquallyWellThatAcrossXIsTaken)
{
    EXPECT_EQ(Symmetry({{{0, 0, 0}, {4, 4, 1}}}).fold({1, 1, 0}), glm::ivec3(3, 1, 0)) << "the plane is at x = 2";
}

} // namespace

} // namespace osgLego::test
