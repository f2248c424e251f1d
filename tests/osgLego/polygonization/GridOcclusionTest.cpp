#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/BrickDimensions.h>
#include <osgLego/data/DistantOcclusion.h>

#include <common/BrickRayCaster.h>
#include <common/RacingCar.h>

#include <LookTest.h>
#include <Probes.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <osg/Geode>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

const osg::Vec3d MIDDLE(0, 0, 0.5);

glm::dvec3 toGlm(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/** The normal of the side of a cell on which a point lies, in pitches; none on a stud. */
std::optional<glm::dvec3> findNormal(const glm::dvec3& point, const glm::dvec3& direction, const glm::dvec3& cell)
{
    const glm::dvec3 offset = glm::abs(point / cell - glm::round(point / cell));
    const int axis = offset.x < offset.y && offset.x < offset.z ? 0 : offset.y < offset.z ? 1 : 2;
    if (offset[axis] > 1e-6) return std::nullopt;
    glm::dvec3 normal(0.0);
    normal[axis] = direction[axis] > 0.0 ? -1.0 : 1.0;
    return normal;
}

/** The horizontal normal of the wall of a stud, on which a point in pitches lies; none elsewhere. */
std::optional<glm::dvec3> findWallNormal(const glm::dvec3& point, const glm::dvec3& cell)
{
    const glm::dvec2 fromAxis(point.x - std::floor(point.x) - 0.5, point.y - std::floor(point.y) - 0.5);
    const double height = point.z - cell.z * std::floor(point.z / cell.z);
    // Studs are prisms.
    const bool isOnWall = std::abs(glm::length(fromAxis) / BrickDimensions::STUD_RADIUS - 0.99) < 0.015;
    if (!isOnWall || height < 0.02 || height > BrickDimensions::STUD_HEIGHT - 0.01) return std::nullopt;
    return glm::dvec3(glm::normalize(fromAxis), 0.0);
}

enum class Surfaces
{
    FACES,
    WALLS_OF_STUDS
};

/** Draws bricks in the light of a white sky alone. */
class GridOcclusion : public LookTest
{
protected:
    struct Error
    {
        double rootMeanSquare;
        double spread; //!< that of a picture without occlusion
        int numPixels;
    };

    static void light(LegoNode& lego)
    {
        osg::ref_ptr<LightProbe> sky = new LightProbe;
        std::string error;
        EXPECT_TRUE(
            sky->setImage(createLatitudeLongitude(32, [](const osg::Vec3d&) { return osg::Vec3d(0.7, 0.7, 0.7); }),
                          LightProbe::LATITUDE_LONGITUDE, error))
            << error;
        lego.setLightProbe(sky);
        lego.setWaiting(true);
        osg::StateSet& stateSet = *lego.getOrCreateStateSet();
        stateSet.setMode(GL_LIGHT0, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    }

    static void setOccluded(LegoNode& lego, bool isOccluded, bool isDistant = false)
    {
        BrickAppearance appearance;
        appearance.joints = false;
        appearance.variation = 0.0;
        appearance.reliefHeight = 0.0;
        appearance.occlusion = isOccluded ? BrickOcclusion::GRID : BrickOcclusion::OFF;
        appearance.distantOcclusion = isDistant;
        EXPECT_TRUE(lego.setAppearance(appearance));
    }

    osg::ref_ptr<osg::Image> drawCar(const std::string& settings, const Viewpoint& viewpoint, bool isOccluded = true)
    {
        const osg::ref_ptr<LegoNode> lego = createCar(settings);
        setOccluded(*lego, isOccluded);
        return draw(*lego, viewpoint);
    }

    static osg::ref_ptr<LegoNode> createCar(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->addChild(createRacingCar());
        light(*lego);
        return lego;
    }

    /** A car of white bricks, which reflect little light besides their colour. */
    static osg::ref_ptr<LegoNode> createWhiteCar(const std::string& settings)
    {
        const osg::ref_ptr<LegoNode> lego = createCar(settings);
        const osg::ref_ptr<const BrickModel> model = lego->getBricks();
        std::vector<Brick> bricks = model->getBricks();
        for (Brick& brick : bricks)
            brick.color = {255, 255, 255};
        lego->setStoredBricks(BrickModel::createComplete(model->getGrid(), bricks));
        return lego;
    }

    /** Bricks with a stair, beside the plane x = 4. */
    static osg::ref_ptr<LegoNode> createStair(BrickOcclusion occlusion)
    {
        BrickGrid grid;
        grid.dimensions = {4, 8, 4};
        std::vector<Brick> bricks;
        for (std::uint16_t z = 0; z < 4; ++z)
            for (std::uint16_t y = 0; y < 8; ++y)
                for (std::uint16_t x = 0; x < 4 - z; ++x)
                    bricks.push_back({{x, y, z}, {200, 200, 200}, 0});
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("8"));
        lego->setStoredBricks(BrickModel::create(grid, bricks));
        lego->setWaiting(true);
        BrickAppearance appearance;
        appearance.occlusion = occlusion;
        lego->setAppearance(appearance);
        return lego;
    }

    /** A floor of bricks, and columns as high as the grid. */
    static osg::ref_ptr<LegoNode> createFloor(const glm::ivec3& dimensions,
                                              const std::function<bool(int x, int y)>& isColumn)
    {
        BrickGrid grid;
        grid.dimensions = dimensions;
        std::vector<Brick> bricks;
        for (std::uint16_t y = 0; y < dimensions.y; ++y)
            for (std::uint16_t x = 0; x < dimensions.x; ++x)
                for (std::uint16_t z = 0; z < (isColumn(x, y) ? dimensions.z : 1); ++z)
                    bricks.push_back({{x, y, z}, {200, 200, 200}, 0});
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("20"));
        lego->setStoredBricks(BrickModel::create(grid, bricks));
        light(*lego);
        return lego;
    }

    /** The error of the light that surfaces show, as a fraction of that without occlusion. */
    Error compareWithRays(LegoNode& lego, const Viewpoint& viewpoint, bool isDistant = false,
                          Surfaces surfaces = Surfaces::FACES)
    {
        setOccluded(lego, false);
        const osg::ref_ptr<osg::Image> open = draw(lego, viewpoint);
        setOccluded(lego, true, isDistant);
        const osg::ref_ptr<osg::Image> occluded = draw(lego, viewpoint);
        const BrickRayCaster caster(*lego.getBricks());
        const BrickGrid& grid = caster.getModel().getGrid();
        const double radius = isDistant ? DistantOcclusion::getReach(grid) : AmbientOcclusionSettings::RADIUS_IN_BRICKS;
        double squares = 0.0;
        double spread = 0.0;
        int count = 0;
        for (int row = 1; row < HEIGHT; row += 3)
            for (int column = 1; column < WIDTH; column += 3)
            {
                const glm::dvec3 origin = caster.toCaster(unproject(column, row, 0.0));
                const glm::dvec3 direction =
                    glm::normalize(toGlm(unproject(column, row, 1.0) - unproject(column, row, 0.0)));
                const auto distance = caster.findNearest(origin, direction, 1e9);
                const double before = brightnessAt(*open, column, row);
                if (!distance || before == 0.0) continue;
                const glm::dvec3 point = origin + *distance * direction;
                const glm::dvec3 cell = grid.cellSize / grid.getPitch();
                const auto normal =
                    surfaces == Surfaces::FACES ? findNormal(point, direction, cell) : findWallNormal(point, cell);
                if (!normal) continue;
                const double visibility =
                    caster.sampleOcclusion(point, *normal, radius, AmbientOcclusionSettings::FALLOFF, 256, 1)
                        .visibility;
                // Colours are powers of light, with the exponent of a dim room (color_space.glsl).
                const double shown = std::pow(brightnessAt(*occluded, column, row) / before, 2.2 / 1.2);
                squares += (shown - visibility) * (shown - visibility);
                spread += (1.0 - visibility) * (1.0 - visibility);
                ++count;
            }
        return {std::sqrt(squares / count), std::sqrt(spread / count), count};
    }

private:
    osg::Vec3d unproject(int column, int row, double depth) const
    {
        const osg::Camera& camera = *_viewer.getCamera();
        return osg::Vec3d(column + 0.5, row + 0.5, depth) *
               osg::Matrixd::inverse(camera.getViewMatrix() * camera.getProjectionMatrix() *
                                     camera.getViewport()->computeWindowMatrix());
    }
};

TEST_F(GridOcclusion, HidesTheLightThatRaysCastAtTheBricksDoNotFind)
{
    for (const char* settings : {"20", "20,proportions=brick", "20,up=y"})
        for (const Viewpoint& viewpoint : {Viewpoint{{4, -8, -4}, MIDDLE}, Viewpoint{{-5, -7, 5}, MIDDLE}})
        {
            const osg::ref_ptr<LegoNode> lego = createWhiteCar(settings);
            const Error error = compareWithRays(*lego, viewpoint);
            ASSERT_GT(error.numPixels, 300) << settings;
            EXPECT_GT(error.spread, 0.15) << settings << ": there is nothing to compare";
            EXPECT_LT(error.rootMeanSquare, 0.033) << settings << ' ' << viewpoint.eye.z();
        }
}

TEST_F(GridOcclusion, IncludesDistantBricks)
{
    // Studs, which only the view from above shows, are less exact.
    for (const auto& [viewpoint, limit] :
         {std::pair{Viewpoint{{4, -8, -4}, MIDDLE}, 0.0225}, {Viewpoint{{-5, -7, 5}, MIDDLE}, 0.03}})
    {
        const osg::ref_ptr<LegoNode> lego = createWhiteCar("32");
        const Error error = compareWithRays(*lego, viewpoint, true);
        ASSERT_GT(error.numPixels, 300);
        EXPECT_LT(error.rootMeanSquare, limit) << viewpoint.eye.z();
    }
}

TEST_F(GridOcclusion, ShowsNoBordersBetweenTheCellsOfAWideFace)
{
    // A wall behind a shelf that is higher on the left.
    BrickGrid grid;
    grid.dimensions = {12, 2, 12};
    std::vector<Brick> bricks;
    for (std::uint16_t z = 0; z < 12; ++z)
        for (std::uint16_t y = 0; y < 2; ++y)
            for (std::uint16_t x = 0; x < 12; ++x)
                if (y == 1 || z < (x < 4 ? 6 : 3)) bricks.push_back({{x, y, z}, {255, 255, 255}, 0});
    for (const auto& shape : {std::pair{"12", 1.0}, {"12,proportions=brick", 1.2}})
    {
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(shape.first));
        const double height = shape.second;
        grid.cellSize.z = height;
        lego->setStoredBricks(BrickModel::create(grid, bricks));
        light(*lego);
        const Viewpoint front{{6, -14, 6}, {6, 0, 6}};
        setOccluded(*lego, false);
        const osg::ref_ptr<osg::Image> open = draw(*lego, front);
        setOccluded(*lego, true, true);
        const osg::ref_ptr<osg::Image> occluded = draw(*lego, front);
        const auto visibilityAt = [&](double x, double z)
        {
            const osg::Vec3d place(x, 1.0, z * height);
            return std::pow(colorAt(*occluded, place).length() / colorAt(*open, place).length(), 2.2 / 1.2);
        };
        EXPECT_LT(visibilityAt(8.5, 3.3), visibilityAt(8.5, 6.5) - 0.2) << "nothing is hidden";
        constexpr double BESIDE = 0.06;
        for (int z = 4; z < 8; ++z)
            for (double x = 5.3; x < 11.0; x += 0.4)
                EXPECT_NEAR(visibilityAt(x, z - BESIDE), visibilityAt(x, z + BESIDE), 0.025) << x << ' ' << z;
        for (int x = 5; x < 11; ++x)
            for (double z = 3.3; z < 9.0; z += 0.4)
                EXPECT_NEAR(visibilityAt(x - BESIDE, z), visibilityAt(x + BESIDE, z), 0.025) << x << ' ' << z;
    }
}

TEST_F(GridOcclusion, HidesTheLightThatRaysDoNotFindBetweenScatteredBricks)
{
    // In the first layer, bricks hide most; without it, the others count.
    BrickGrid grid;
    grid.dimensions = glm::ivec3(9);
    std::mt19937 random(5);
    std::vector<Brick> bricks;
    for (std::uint16_t z = 0; z < 9; ++z)
        for (std::uint16_t y = 0; y < 9; ++y)
            for (std::uint16_t x = 0; x < 9; ++x)
                if (random() % 100 < 12) bricks.push_back({{x, y, z}, {200, 200, 200}, 0});
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("9"));
    lego->setStoredBricks(BrickModel::create(grid, bricks));
    light(*lego);
    const osg::Vec3d middle = osg::Vec3d(lego->getBound().center());
    for (const osg::Vec3d& direction :
         {osg::Vec3d(2, 3, -4), osg::Vec3d(-4, 3, -2), osg::Vec3d(-3, -4, -2), osg::Vec3d(4, -2, -3)})
    {
        const Error error = compareWithRays(*lego, {middle + direction * (0.9 * lego->getBound().radius()), middle});
        ASSERT_GT(error.numPixels, 300);
        EXPECT_LT(error.rootMeanSquare, 0.034) << direction.x();
    }
}

TEST_F(GridOcclusion, HidesTheLightThatRaysDoNotFindFromTheWallsOfStuds)
{
    const osg::ref_ptr<LegoNode> lego = createFloor({7, 7, 3}, [](int x, int y) { return x == 3 && y % 3 == 0; });
    for (const osg::Vec3d& eye : {osg::Vec3d(1, -3, 4), osg::Vec3d(10, 2, 4), osg::Vec3d(5, 10, 4)})
    {
        const Error error = compareWithRays(*lego, {eye, {3.5, 3.5, 1}}, false, Surfaces::WALLS_OF_STUDS);
        ASSERT_GT(error.numPixels, 200);
        EXPECT_GT(error.spread, 0.5) << "there is nothing to compare";
        EXPECT_LT(error.rootMeanSquare, 0.033) << eye.x();
    }
}

TEST_F(GridOcclusion, HasNoGapBetweenNearAndDistantBricksInLargeModels)
{
    // So long that voxels of distant occlusion are three cells wide.
    const osg::ref_ptr<LegoNode> lego = createFloor({260, 20, 20}, [](int x, int) { return x == 130; });
    for (const osg::Vec3d& eye : {osg::Vec3d(141, -6, 9), osg::Vec3d(119, 4, 14)})
    {
        const Error error = compareWithRays(*lego, {eye, {131, 10, 3}}, true);
        ASSERT_GT(error.numPixels, 1000);
        EXPECT_GT(error.spread, 0.2) << "there is nothing to compare";
        EXPECT_LT(error.rootMeanSquare, 0.08) << eye.x();
    }
}

TEST_F(GridOcclusion, IncludesDistantBricksOnTheWallsOfStuds)
{
    // High walls at a distance of up to four bricks, within the reach of five.
    const osg::ref_ptr<LegoNode> lego = createFloor({20, 20, 10}, [](int x, int) { return x % 9 == 0; });
    const Error error = compareWithRays(*lego, {{13.5, -4, 8}, {13.5, 6, 1}}, true, Surfaces::WALLS_OF_STUDS);
    ASSERT_GT(error.numPixels, 100);
    EXPECT_LT(error.rootMeanSquare, 0.045);
}

TEST_F(GridOcclusion, ComesFromBricksBeyondTwoEmptyLayers)
{
    BrickGrid grid;
    grid.dimensions = {9, 9, 4};
    std::vector<Brick> bricks;
    for (std::uint16_t y = 0; y < 9; ++y)
        for (std::uint16_t x = 0; x < 9; ++x)
            for (const std::uint16_t z : {std::uint16_t(0), std::uint16_t(3)})
                bricks.push_back({{x, y, z}, {200, 200, 200}, 0});
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("9"));
    lego->setStoredBricks(BrickModel::create(grid, bricks));
    light(*lego);
    const Error error = compareWithRays(*lego, {{4.5, -9, 2.6}, {4.5, 4.5, 1.6}});
    ASSERT_GT(error.numPixels, 300);
    EXPECT_GT(error.spread, 0.06);
    EXPECT_LT(error.rootMeanSquare, 0.015);
}

TEST_F(GridOcclusion, IsTheSameInBothDrawingsAndOnBothDevices)
{
    const Viewpoint viewpoint{{5, -9, 5}, MIDDLE};
    for (const std::string settings : {"20", "24,up=y,proportions=plate", "20,parts=bricks,device=cpu"})
    {
        const osg::ref_ptr<osg::Image> splats = drawCar(settings + ",drawing=splats", viewpoint);
        const osg::ref_ptr<osg::Image> triangles = drawCar(settings + ",drawing=triangles", viewpoint);
        EXPECT_LE(countDifferent(*splats, *triangles, 3), WIDTH * HEIGHT / 400u) << settings;
        EXPECT_GT(countDifferent(*splats, *drawCar(settings, viewpoint, false), 3), WIDTH * HEIGHT / 40u) << settings;
        if (settings.find("parts") != std::string::npos) continue; // these are made on the CPU
        EXPECT_LE(countDifferent(*drawCar(settings + ",device=gpu", viewpoint),
                                 *drawCar(settings + ",device=cpu", viewpoint), 3),
                  WIDTH * HEIGHT / 400u)
            << settings;
    }
}

TEST_F(GridOcclusion, OfANodeIsTheSameInAnAmbientOcclusionScene)
{
    const Viewpoint viewpoint{{12, -8, 9}, {3, 4, 1}};
    const osg::ref_ptr<osg::Image> alone = draw(*createStair(BrickOcclusion::GRID), viewpoint);
    const osg::ref_ptr<osg::Image> open = draw(*createStair(BrickOcclusion::OFF), viewpoint);
    EXPECT_GT(meanDifference(*alone, *open), 2.0) << "there is nothing to compare";
    for (const BrickOcclusion occlusion : {BrickOcclusion::GRID, BrickOcclusion::BOTH})
        EXPECT_LT(meanDifference(*draw(*createGroup("medium", createStair(occlusion)), viewpoint), *alone), 0.4);
    EXPECT_LT(meanDifference(*draw(*createGroup("medium", createStair(BrickOcclusion::OFF)), viewpoint), *open), 0.2);
}

TEST_F(GridOcclusion, LeavesTheOcclusionByOtherNodesToThePictureIfBothAreWanted)
{
    const Viewpoint viewpoint{{2, -10, 8}, {3, 4, 1}};
    const osg::ref_ptr<LegoNode> otherBricks = createBrickBox({8, 8, 8}, "8");
    const osg::ref_ptr<osg::MatrixTransform> beside = new osg::MatrixTransform(osg::Matrixd::translate(4, 0, -3));
    beside->addChild(otherBricks);
    const osg::ref_ptr<osg::Geode> wall = new osg::Geode;
    wall->addDrawable(createQuad({4, 8, -3}, {0, -8, 0}, {0, 0, 8}, {0.8f, 0.8f, 0.8f, 1.0f}));
    for (const osg::ref_ptr<osg::Node>& other : {osg::ref_ptr<osg::Node>(beside), osg::ref_ptr<osg::Node>(wall)})
        for (const auto& [occlusion, isOccluded] :
             {std::pair{BrickOcclusion::GRID, false}, {BrickOcclusion::OFF, false}, {BrickOcclusion::BOTH, true}})
        {
            const osg::ref_ptr<osg::Group> both = new osg::Group;
            both->addChild(createStair(occlusion));
            const osg::ref_ptr<osg::Image> alone = draw(*createGroup("medium", both), viewpoint);
            const double before = colorAt(*alone, {3.9, 4.0, 1.0}).length();
            both->addChild(other);
            const osg::ref_ptr<osg::Image> image = draw(*createGroup("medium", both), viewpoint);
            const double after = colorAt(*image, {3.9, 4.0, 1.0}).length();
            ASSERT_GT(before, 0.2);
            if (isOccluded)
                EXPECT_LT(after, 0.93 * before) << other->className();
            else
                EXPECT_NEAR(after, before, 0.01) << other->className();
        }
}

TEST_F(GridOcclusion, LeavesABrickThatStandsAloneAsItIs)
{
    const Viewpoint front{{0.5, 0.5, -9}, {0.5, 0.5, 0}, {0, 1, 0}, 2.0};
    osg::ref_ptr<LegoNode> brick = createBrickBox({1, 1, 1}, "1");
    BrickAppearance appearance;
    appearance.occlusion = BrickOcclusion::OFF;
    brick->setAppearance(appearance);
    const osg::ref_ptr<osg::Image> open = draw(*brick, front);
    appearance.occlusion = BrickOcclusion::GRID;
    brick->setAppearance(appearance);
    EXPECT_GT(countDrawn(*open), 1000u);
    EXPECT_EQ(countDifferent(*draw(*brick, front), *open, 1), 0u);
}

} // namespace

} // namespace osgLego::test
