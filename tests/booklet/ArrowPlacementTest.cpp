#include <booklet/ArrowPlacement.h>
#include <booklet/ArrowShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr double WIDTH = 0.45;
const BookletFrame AREA{{0.0, 0.0}, {30.0, 20.0}};

/** Some targets in the area, at least a distance apart. */
std::vector<ArrowTarget> createTargets(std::size_t number, double distance, const glm::dvec2& size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<ArrowTarget> targets;
    while (targets.size() < number)
    {
        const glm::dvec2 tip = glm::dvec2(4.0, 4.0) + glm::dvec2(share(random), share(random)) * size;
        if (std::all_of(targets.begin(), targets.end(),
                        [&](const ArrowTarget& other) { return glm::distance(other.tip, tip) >= distance; }))
            targets.push_back({tip, random() % 3});
    }
    return targets;
}

/** Whether a point is on the left of each side of a polygon, or on the right of each. */
template <std::size_t N>
bool isInside(const glm::dvec2& point, const std::array<glm::dvec2, N>& corners)
{
    int numLeft = 0;
    for (std::size_t corner = 0; corner < N; ++corner)
    {
        const glm::dvec2 side = corners[(corner + 1) % N] - corners[corner];
        const glm::dvec2 to = point - corners[corner];
        numLeft += side.x * to.y - side.y * to.x > 0.0 ? 1 : 0;
    }
    return numLeft == 0 || numLeft == static_cast<int>(N);
}

/** Whether a point is on the shaft, on the head, or in the box of the letter of an arrow. A bold letter of Arial is up
 * to 0.95 sizes of the font wide and 0.72 high. */
bool isOn(const glm::dvec2& point, const BookletArrow& arrow, std::size_t numCharacters)
{
    const auto corners = arrow.getCorners();
    const glm::dvec2 letter = point - arrow.letter;
    const double size = 3.0 * arrow.width;
    return isInside(point, std::array{corners[0], corners[1], corners[5], corners[6]}) ||
           isInside(point, std::array{corners[2], corners[3], corners[4]}) ||
           (std::abs(letter.x) < 0.475 * size * static_cast<double>(numCharacters) && letter.y > 0.0 &&
            letter.y < 0.72 * size);
}

/** The places of a fine grid at which two arrows are, and those at which an arrow is outside of a frame. */
std::pair<int, int> countFaults(const std::vector<ArrowTarget>& targets, const ArrowPlacement& placement)
{
    const double step = 0.25 * placement.getArrows().front().width;
    int numTwice = 0;
    int numOutside = 0;
    for (double y = -15.0; y < 50.0; y += step)
        for (double x = -30.0; x < 60.0; x += step)
        {
            const glm::dvec2 point(x, y);
            int number = 0;
            for (std::size_t index = 0; index < targets.size(); ++index)
            {
                const BookletArrow& arrow = placement.getArrows()[index];
                if (glm::distance(point, arrow.tip) > 40.0 * arrow.width) continue;
                number += isOn(point, arrow, targets[index].numCharacters) ? 1 : 0;
            }
            const BookletFrame& frame = *placement.getFrame();
            const bool isOutside =
                x < frame.lowest.x || x > frame.highest.x || y < frame.lowest.y || y > frame.highest.y;
            numTwice += number > 1 ? 1 : 0;
            numOutside += number > 0 && isOutside ? 1 : 0;
        }
    return {numTwice, numOutside};
}

void expectGoodArrows(const std::vector<ArrowTarget>& targets, const ArrowPlacement& placement)
{
    ASSERT_EQ(placement.getArrows().size(), targets.size());
    for (std::size_t index = 0; index < targets.size(); ++index)
    {
        const BookletArrow& arrow = placement.getArrows()[index];
        EXPECT_EQ(arrow.tip, targets[index].tip);
        EXPECT_GT(arrow.tail.y, arrow.tip.y);
        EXPECT_GE(glm::distance(arrow.tail, arrow.tip), 4.5 * arrow.width) << "its shaft is longer than its head";
        EXPECT_EQ(arrow.width, placement.getArrows().front().width);
    }
    const auto [numTwice, numOutside] = countFaults(targets, placement);
    EXPECT_EQ(numTwice, 0) << "arrows or letters overlap";
    EXPECT_EQ(numOutside, 0) << "the frame cuts arrows or letters";
}

} // namespace

TEST(ArrowPlacement, ArrowsAndLettersToRandomPlacesDoNotOverlapAndAreInTheFrame)
{
    for (unsigned seed = 0; seed < 40; ++seed)
    {
        SCOPED_TRACE(seed);
        const std::vector<ArrowTarget> targets = createTargets(1 + seed % 8, 1.0, {20.0, 10.0}, seed);
        const ArrowPlacement placement(targets, WIDTH, AREA, {});
        expectGoodArrows(targets, placement);
        EXPECT_EQ(placement.getArrows().front().width, WIDTH);
    }
}

TEST(ArrowPlacement, ArrowsToCrowdedPlacesDoNotOverlapEither)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        SCOPED_TRACE(seed);
        const std::vector<ArrowTarget> targets = createTargets(2 + seed % 7, 0.35, {2.5, 2.5}, seed);
        expectGoodArrows(targets, ArrowPlacement(targets, WIDTH, AREA, {}));
    }
}

TEST(ArrowPlacement, AnArrowAloneIsUprightAndOfTheUsualWidth)
{
    const ArrowTarget target{{10.0, 8.0}, 1};
    const BookletArrow arrow = ArrowPlacement({&target, 1}, WIDTH, AREA, {}).getArrows().front();
    EXPECT_DOUBLE_EQ(arrow.tail.x, arrow.tip.x);
    EXPECT_DOUBLE_EQ(arrow.letter.x, arrow.tip.x);
    EXPECT_GT(arrow.letter.y, arrow.tail.y);
    EXPECT_EQ(arrow.width, WIDTH);
}

TEST(ArrowPlacement, LettersCoverNoShownPartsWhereOtherPlacesAreFree)
{
    // A part above the target, where the letter of an upright arrow would be.
    const ArrowTarget target{{15.0, 8.0}, 1};
    const BookletFrame part{{13.5, 10.5}, {16.5, 13.5}};
    const BookletArrow arrow = ArrowPlacement({&target, 1}, WIDTH, AREA, {&part, 1}).getArrows().front();
    for (double y = part.lowest.y; y < part.highest.y; y += 0.05)
        for (double x = part.lowest.x; x < part.highest.x; x += 0.05)
            ASSERT_FALSE(isOn({x, y}, arrow, 1)) << x << " " << y;
}

TEST(ArrowPlacement, ArrowsAtTheSideOfTheModelDoNotWidenThePicture)
{
    for (const double x : {1.0, 29.0})
    {
        const std::array targets{ArrowTarget{{x, 8.0}, 2}, ArrowTarget{{x, 10.0}, 2}};
        const ArrowPlacement placement(targets, WIDTH, AREA, {});
        EXPECT_GE(placement.getFrame()->lowest.x, AREA.lowest.x) << x;
        EXPECT_LE(placement.getFrame()->highest.x, AREA.highest.x) << x;
    }
}

TEST(ArrowPlacement, NoTargetsNeedNoFrame)
{
    const ArrowPlacement placement({}, WIDTH, AREA, {});
    EXPECT_TRUE(placement.getArrows().empty());
    EXPECT_FALSE(placement.getFrame());
}

TEST(ArrowPlacement, EqualTargetsHaveArrowsAllTheSame)
{
    const std::array targets{ArrowTarget{{5.0, 5.0}, 0}, ArrowTarget{{5.0, 5.0}, 1}};
    const ArrowPlacement placement(targets, WIDTH, AREA, {});
    ASSERT_EQ(placement.getArrows().size(), 2u);
    EXPECT_EQ(placement.getArrows()[0].tip, placement.getArrows()[1].tip);
}

} // namespace osgLego
