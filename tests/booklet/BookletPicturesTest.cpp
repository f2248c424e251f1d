#include <booklet/BookletPictures.h>
#include <booklet/NewPartOutline.h>

#include "BookletModels.h"

#include <PartModels.h>
#include <offscreen/OffscreenContext.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr std::array<std::uint8_t, 3> RED{180, 0, 0};
constexpr std::array<std::uint8_t, 3> BLUE{30, 90, 168};
constexpr double HEIGHT_OF_BRICK = 1.2; // pitches
constexpr double MARGIN = 0.15;         // pitches around the parts

struct Color
{
    double red = 0.0; // 0 to 1
    double green = 0.0;
    double blue = 0.0;

    bool isRed() const { return red > blue + 0.1; }
    /** The difference between the largest and the smallest channel, relative to the largest. */
    double getSaturation() const { return 1.0 - std::min({red, green, blue}) / std::max({red, green, blue}); }
};

/** The pixels of an encoded picture. */
class Pixels
{
public:
    explicit Pixels(const BookletPicture& picture)
    {
        OIIO::Filesystem::IOMemReader reader(const_cast<char*>(picture.bytes.data()), picture.bytes.size());
        const std::string name = picture.mediaType == "image/jpeg" ? "a.jpg" : "a.webp";
        const auto input = OIIO::ImageInput::open(name, nullptr, &reader);
        if (!input) throw std::runtime_error(OIIO::geterror());
        _width = input->spec().width;
        _height = input->spec().height;
        _channels = input->spec().nchannels;
        _bytes.resize(static_cast<std::size_t>(_width * _height * _channels));
        input->read_image(0, 0, 0, _channels, OIIO::TypeDesc::UINT8, _bytes.data());
        EXPECT_EQ(_width, picture.width);
        EXPECT_EQ(_height, picture.height);
    }

    int getWidth() const { return _width; }
    int getHeight() const { return _height; }

    /** The mean colour of some pixels about a place, in pixels from the top left. */
    Color getColor(const glm::dvec2& place) const
    {
        constexpr int REACH = 2;
        constexpr double SCALE = 1.0 / (255.0 * (2 * REACH + 1) * (2 * REACH + 1));
        std::array<double, 3> sum{};
        for (int y = -REACH; y <= REACH; ++y)
            for (int x = -REACH; x <= REACH; ++x)
                for (int channel = 0; channel < 3; ++channel)
                    sum[static_cast<std::size_t>(channel)] +=
                        SCALE *
                        _bytes.at(static_cast<std::size_t>(
                            ((static_cast<int>(place.y) + y) * _width + static_cast<int>(place.x) + x) * _channels +
                            channel));
        return {sum[0], sum[1], sum[2]};
    }

private:
    int _width = 0;
    int _height = 0;
    int _channels = 0;
    std::vector<std::uint8_t> _bytes;
};

/** The projection of booklets: parallel, from 33 degrees to the right of the front and 30 above the horizon, turned by
 * quarters counter-clockwise from above. Upside down, the eye is below, and the picture is turned by half. */
class Projection
{
public:
    Projection(int turns, bool isUpsideDown) :
        _azimuth((33.0 + 90.0 * turns) * std::numbers::pi / 180.0), _sign(isUpsideDown ? -1.0 : 1.0)
    {
    }

    /** @param place in pitches: x to the right, y away and z upwards. @return pitches, to the right and upwards. */
    glm::dvec2 project(const glm::dvec3& place) const
    {
        const double right = place.x * std::cos(_azimuth) + place.y * std::sin(_azimuth);
        const double near = place.x * std::sin(_azimuth) - place.y * std::cos(_azimuth);
        return {_sign * right, _sign * place.z * std::cos(std::numbers::pi / 6.0) - 0.5 * near};
    }

private:
    double _azimuth;
    double _sign;
};

/** Finds places in the pictures of a chapter's steps. */
class StepPicture
{
public:
    /** @param placed the parts in place, and then the others of the chapter.
     * @param width of the widest view of the chapter, in pitches; 0 for that of this view. */
    StepPicture(const Projection& projection, std::vector<Part> parts, std::size_t numPlaced, const glm::ivec2& pixels,
                double width = 0.0) :
        _projection(projection),
        _pixels(pixels)
    {
        double left = std::numeric_limits<double>::max();
        double right = std::numeric_limits<double>::lowest();
        for (std::size_t index = 0; index < parts.size(); ++index)
            for (int corner = 0; corner < 8; ++corner)
            {
                const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
                glm::dvec3 place = glm::dvec3(parts[index].getCell()) + share * glm::dvec3(parts[index].getSize());
                place.z = place.z * HEIGHT_OF_BRICK + (corner >> 2) * STUD;
                const glm::dvec2 point = projection.project(place);
                left = std::min(left, point.x);
                right = std::max(right, point.x);
                if (index < numPlaced) _bottom = std::min(_bottom, point.y - MARGIN);
            }
        if (width == 0.0) width = right - left + 2.0 * MARGIN;
        _left = 0.5 * (left + right) - 0.5 * width;
        _scale = pixels.x / width;
    }

    /** @param place in studs and layers. @return pixels from the top left. */
    glm::dvec2 find(glm::dvec3 place) const
    {
        place.z *= HEIGHT_OF_BRICK;
        const glm::dvec2 point = _projection.project(place);
        return {(point.x - _left) * _scale, _pixels.y - (point.y - _bottom) * _scale};
    }

    double getScale() const { return _scale; }

private:
    static constexpr double STUD = 0.2; // its height, in pitches

    Projection _projection;
    glm::ivec2 _pixels;
    double _left = 0.0;
    double _bottom = std::numeric_limits<double>::max();
    double _scale = 0.0; // pixels per pitch
};

} // namespace

class BookletPicturesTest : public testing::Test
{
protected:
    BookletPicturesTest() : _renderer(*_context) {}

private:
    static osg::ref_ptr<osg::GraphicsContext> createContext()
    {
        std::string error;
        osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(16, 16, error);
        if (!context) throw std::runtime_error(error);
        return context;
    }

    osg::ref_ptr<osg::GraphicsContext> _context = createContext();

protected:
    BookletRenderer _renderer;
};

TEST_F(BookletPicturesTest, StepsHighlightTheirNewPartsAndFadeTheOthers)
{
    // Two red bricks side by side, which two steps place; the middle of the front of each is visible.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    for (const bool isReversed : {false, true})
    {
        const auto plan =
            BuildingPlan::create(2, {createStep({isReversed ? 1u : 0u}), createStep({isReversed ? 0u : 1u})});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(0, 1));
        const StepPicture place({0, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const double left = pixels.getColor(place.find({2, 0, 0.5})).getSaturation();
        const double right = pixels.getColor(place.find({6, 0, 0.5})).getSaturation();
        EXPECT_GT(isReversed ? left : right, 0.8) << "the new part";
        EXPECT_LT(isReversed ? right : left, 0.6) << "the part of the step before";
        EXPECT_GT(isReversed ? right : left, 0.1) << "it keeps its colour";
    }
}

TEST_F(BookletPicturesTest, StepsShowOnlyThePartsInPlaceAtTheSamePlaceInEachPicture)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({1})});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    for (const std::size_t step : {0, 1})
    {
        const Pixels pixels(pictures.drawStep(0, step));
        const StepPicture place({0, false}, parts, step + 1, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_TRUE(pixels.getColor(place.find({2, 0, 0.5})).isRed());
        const Color second = pixels.getColor(place.find({6, 0, 0.5}));
        if (step == 0)
            EXPECT_LT(second.getSaturation(), 0.02) << "white";
        else
            EXPECT_GT(second.blue, second.red + 0.2);
    }
}

TEST_F(BookletPicturesTest, StepsAreShownFromTheDirectionThatTheirTurnsSay)
{
    // A row of a red and a blue brick: the red end is on the left from the front and the right, and on the right
    // otherwise.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    // The middle of a side that is visible: the front, the right, the back and the left.
    const std::array<std::array<glm::dvec3, 2>, 4> sides{{{{{2, 0, 0.5}, {6, 0, 0.5}}},
                                                          {{{2, 2, 0.5}, {6, 2, 0.5}}},
                                                          {{{2, 2, 0.5}, {6, 2, 0.5}}},
                                                          {{{2, 0, 0.5}, {6, 0, 0.5}}}}};
    for (int turns = 0; turns < 4; ++turns)
    {
        BuildingStep step = createStep({0, 1});
        step.turns = turns;
        const auto plan = BuildingPlan::create(2, {step});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(0, 0));
        const StepPicture place({turns, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const auto& [red, blue] = sides[static_cast<std::size_t>(turns)];
        EXPECT_TRUE(pixels.getColor(place.find(red)).isRed()) << turns;
        const Color color = pixels.getColor(place.find(blue));
        EXPECT_GT(color.blue, color.red + 0.2) << turns;
    }
}

TEST_F(BookletPicturesTest, ColorsLookAlikeBeforeAndAfterATurn)
{
    // A turn shows other sides of a square brick at the same places of the picture; upside down, its bottom is on top.
    for (const std::array<std::uint8_t, 3> shown : {std::array<std::uint8_t, 3>{244, 244, 244}, {250, 200, 10}})
    {
        const std::vector<Part> parts{{{0, 0, 0}, {4, 4, 1}, shown, Part::NO_CODE}};
        const auto bricks = BrickModel::createOfParts(createPartGrid({4, 4, 1}, HEIGHT_OF_BRICK), parts);
        std::array<Color, 3> before;
        for (int turns = 0; turns < 4; ++turns)
        {
            BuildingStep step = createStep({0});
            step.turns = turns;
            const BookletModel model(*bricks, *BuildingPlan::create(1, {step}), {});
            const Pixels pixels(BookletPictures(model, _renderer).drawStep(0, 0));
            const StepPicture place({0, false}, parts, 1, {pixels.getWidth(), pixels.getHeight()});
            const std::array<glm::dvec3, 3> places{
                {{2, 0, 0.5}, {4, 2, 0.5}, {2, 2, 1}}}; // the left, the right, the top
            for (std::size_t side = 0; side < places.size(); ++side)
            {
                const Color color = pixels.getColor(place.find(places[side]));
                if (turns == 0) before[side] = color;
                EXPECT_NEAR(color.red, before[side].red, 0.02) << turns << " turns, side " << side;
                EXPECT_NEAR(color.green, before[side].green, 0.02) << turns << " turns, side " << side;
                EXPECT_NEAR(color.blue, before[side].blue, 0.02) << turns << " turns, side " << side;
            }
        }
    }
}

TEST_F(BookletPicturesTest, NewPartsHaveAnOutlineOfEnoughContrastOnModelsOfOneColor)
{
    // An old brick on the left, and a new one beside it; in white, grey, black, yellow, red, blue and tan.
    for (const std::array<std::uint8_t, 3> shown : {std::array<std::uint8_t, 3>{244, 244, 244},
                                                    {150, 150, 150},
                                                    {33, 33, 33},
                                                    {250, 200, 10},
                                                    RED,
                                                    BLUE,
                                                    {215, 186, 140}})
    {
        const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, shown}, {{4, 0, 0}, {4, 2, 1}, shown}};
        const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
        const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({1})});
        const BookletModel model(*bricks, *plan, {});
        const Pixels pixels(BookletPictures(model, _renderer).drawStep(0, 1));
        const StepPicture place({0, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const auto toPixel = [](const Color& color)
        {
            const auto toByte = [](double value) { return static_cast<std::uint8_t>(std::lround(255.0 * value)); };
            return PixelColor{toByte(color.red), toByte(color.green), toByte(color.blue)};
        };
        // The line is a few pixels wide, to the left of the seam on the front, and below the lower edge on the right.
        for (const auto& [edge, outwards] :
             {std::pair(glm::dvec3(4, 0, 0.5), glm::dvec2(-1, 0)), std::pair(glm::dvec3(6, 0, 0), glm::dvec2(0, 1))})
        {
            const PixelColor line = toPixel(pixels.getColor(place.find(edge) + 3.0 * outwards));
            const PixelColor beside = toPixel(pixels.getColor(place.find(edge) + 20.0 * outwards));
            EXPECT_GE(getContrast(line, beside), NewPartOutline::LEAST_CONTRAST)
                << static_cast<int>(shown[0]) << " " << static_cast<int>(line[0]) << "," << static_cast<int>(line[1])
                << "," << static_cast<int>(line[2]) << " beside " << static_cast<int>(beside[0]);
        }
    }
}

TEST_F(BookletPicturesTest, TheFrontIsTheGivenViewForTheCoverAndForSteps)
{
    // A row of a red and a blue brick, seen from the back: the red end is on the right.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(2, {createStep({0, 1})}), Palette::getKnownColors());
    BookletPictures pictures(model, _renderer, {213.0, BuildingStep::ELEVATION});
    for (const BookletPicture& picture : {pictures.drawStep(0, 0), pictures.drawFinished(0)})
    {
        const Pixels pixels(picture);
        const StepPicture place({2, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_TRUE(pixels.getColor(place.find({2, 2, 0.5})).isRed());
        EXPECT_FALSE(pixels.getColor(place.find({6, 2, 0.5})).isRed());
    }
}

TEST_F(BookletPicturesTest, ModelsOnABasePlateAreShownOnIt)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 4, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({4, 4, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors(),
                             BuildingBase::PLATE);
    BookletPictures pictures(model, _renderer);
    // The plate has 16 x 8 studs.
    const Projection projection(0, false);
    const double width = projection.project({16, 8, 0}).x - projection.project({0, 0, 0}).x + 2.0 * MARGIN;
    for (const BookletPicture& picture : {pictures.drawStep(0, 0), pictures.drawFinished(0)})
    {
        const Pixels pixels(picture);
        const double scale = pixels.getWidth() / width;
        // From the middle of the front of the plate: its near corner is the lowest point, its right the rightmost one.
        const glm::dvec2 place = projection.project({5.5, 0.5, 0.0}) - projection.project({0, 0, -0.2});
        const glm::dvec2 lowest = projection.project({16, 0, 0}) - projection.project({0, 0, 0});
        const Color color =
            pixels.getColor({(place.x + MARGIN) * scale, pixels.getHeight() - (place.y - lowest.y + MARGIN) * scale});
        EXPECT_GT(color.green, color.red + 0.03);
        EXPECT_GT(color.green, color.blue);
    }
}

TEST_F(BookletPicturesTest, StepsFromBelowShowTheModelUpsideDown)
{
    // A blue brick on a red one; both in a submodel that hangs from a beam on a column.
    const std::vector<Part> parts{{{4, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 1}, {4, 2, 1}, BLUE, 1}};
    std::vector<Part> all = parts;
    all.push_back({{0, 0, 0}, {2, 2, 1}, RED, 4});
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), all);
    const auto indexOf = [&bricks](const glm::ivec3& cell)
    { return static_cast<std::uint32_t>(bricks->findPart(cell) - bricks->getParts().data()); };
    for (const bool isUpsideDown : {false, true})
    {
        BuildingStep step = createStep({indexOf({4, 0, 0}), indexOf({4, 0, 1})});
        step.isFromBelow = isUpsideDown;
        const auto plan = BuildingPlan::create(3, {createStep({indexOf({0, 0, 0})}, {0})}, {{{step}}});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(1, 0));
        const StepPicture place({0, isUpsideDown}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const glm::dvec2 red = place.find({6, 0, 0.5});
        const glm::dvec2 blue = place.find({6, 0, 1.5});
        EXPECT_EQ(red.y < blue.y, isUpsideDown);
        EXPECT_TRUE(pixels.getColor(red).isRed()) << isUpsideDown;
        const Color color = pixels.getColor(blue);
        EXPECT_GT(color.blue, color.red + 0.2) << isUpsideDown;
    }
}

TEST_F(BookletPicturesTest, ArrowsLeadFromAboveToTheTopOfSubmodels)
{
    // A base, and a submodel of one brick on its right end.
    const std::vector<Part> parts{{{0, 0, 0}, {8, 2, 1}, RED, 4}, {{4, 0, 1}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(2, {createStep({0}, {0})}, {{{createStep({1})}}});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    const BookletPicture picture = pictures.drawStep(0, 0);
    ASSERT_EQ(picture.arrows.size(), 1u);
    const BookletArrow& arrow = picture.arrows[0];
    const StepPicture place({0, false}, parts, 2, {picture.width, picture.height});
    // The highest corner is the one behind at the left; the middle is that of the front right and the back left corner.
    const glm::dvec2 top = place.find({4, 2, 2});
    const double middle = 0.5 * (place.find({4, 0, 2}).x + place.find({8, 2, 2}).x);
    EXPECT_NEAR(arrow.tip.x, middle, 1.0);
    EXPECT_NEAR(arrow.tail.x, middle, 1.0);
    EXPECT_LT(arrow.tip.y, top.y) << "the arrow ends above the submodel";
    EXPECT_GT(arrow.tip.y, top.y - place.getScale()) << "less than a pitch above its studs";
    EXPECT_LT(arrow.tail.y, arrow.tip.y - place.getScale()) << "it points downwards";
    EXPECT_GT(arrow.tail.y, 0.0) << "all of it is in the picture";
    EXPECT_TRUE(BookletPictures(model, _renderer).drawStep(1, 0).arrows.empty());
}

TEST_F(BookletPicturesTest, ArrowsAndTheirLettersAreApart)
{
    // Three submodels of one brick each, one behind the other: their middles are near each other in the picture.
    std::vector<Part> parts{{{0, 0, 0}, {8, 8, 1}, RED, 4}};
    std::vector<Submodel> submodels;
    for (std::uint16_t place = 0; place < 3; ++place)
    {
        const auto x = static_cast<std::uint16_t>(2 * place);
        parts.push_back({{x, x, 1}, {2, 2, 1}, BLUE, 1});
        submodels.push_back({{createStep({place + 1u})}});
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 8, 2}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(4, {createStep({0}, {0, 1, 2})}, submodels);
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    const BookletPicture picture = BookletPictures(model, _renderer).drawStep(0, 0);
    ASSERT_EQ(picture.arrows.size(), 3u);
    std::vector<double> tails;
    for (const BookletArrow& arrow : picture.arrows)
        tails.push_back(arrow.tail.x);
    std::sort(tails.begin(), tails.end());
    const double width = picture.arrows[0].width;
    // A letter is as wide as three shafts at most, beside the shaft of its arrow, whose head is as wide.
    for (const std::size_t tail : {1, 2})
        EXPECT_GT(tails[tail] - tails[tail - 1], 5.0 * width);
    EXPECT_LT(tails.back() + 4.0 * width, picture.width) << "the last letter is in the picture";
}

TEST_F(BookletPicturesTest, StepsOfAChapterAreAsWideAsItsWidestView)
{
    // From the front, a long brick is wider than from the side; the widest view comes first or last.
    const std::vector<Part> parts{{{0, 0, 0}, {8, 2, 1}, RED, 4}, {{0, 0, 1}, {8, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), parts);
    const Projection front(0, false);
    const double widest = front.project({8, 2, 0}).x - front.project({0, 0, 0}).x;
    const double width = 120.0 * (widest + 2.0 * MARGIN); // the largest scale of steps, in pixels a stud
    for (const int first : {0, 1})
    {
        std::vector<BuildingStep> steps{createStep({0}), createStep({1})};
        steps[0].turns = first;
        steps[1].turns = 1 - first;
        const BookletModel model(*bricks, *BuildingPlan::create(2, steps), Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        for (const std::size_t step : {0, 1})
            EXPECT_NEAR(pictures.drawStep(0, step).width, width, 1.0) << first;
    }
}

TEST_F(BookletPicturesTest, KindsLieWithTheirLongSideToTheRight)
{
    const std::vector<Part> parts{{{0, 0, 0}, {2, 8, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 8, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors());
    const BookletPicture picture = BookletPictures(model, _renderer).drawKind(0);
    const Projection projection(0, false);
    const double width = projection.project({8, 2, 0}).x - projection.project({0, 0, 0}).x + 2.0 * MARGIN;
    EXPECT_NEAR(picture.width, 60.0 * width, 1.0) << "20 pixels of CSS a stud, at three times the density";
}

TEST_F(BookletPicturesTest, KindsAndFinishedModelsHaveTransparentBackgroundsAndFullColors)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({4, 2, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    for (const BookletPicture& picture : {pictures.drawKind(0), pictures.drawFinished(0)})
    {
        EXPECT_EQ(picture.mediaType, "image/webp");
        const Pixels pixels(picture);
        const StepPicture place({0, false}, parts, 1, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_GT(pixels.getColor(place.find({2, 0, 0.5})).getSaturation(), 0.8);
    }
}

} // namespace osgLego::test
