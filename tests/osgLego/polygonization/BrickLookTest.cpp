#include <LookTest.h>
#include <Probes.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <osg/Fog>
#include <osg/Material>

namespace osgLego::test
{

namespace
{

const osg::Vec4 GREY(0.6f, 0.6f, 0.6f, 1.0f);

// The wall that WALL_VIEW shows.
const osg::Vec3 WALL_SIZE(20, 1, 20);

class BrickLook : public LookTest
{
protected:
    static osg::ref_ptr<LegoNode> createWall(const BrickAppearance& appearance, const char* settings = "20")
    {
        osg::ref_ptr<LegoNode> wall = createBrickBox(WALL_SIZE, settings, GREY);
        EXPECT_TRUE(wall->setAppearance(appearance));
        return wall;
    }
};

TEST_F(BrickLook, JointsMakeAGridOfDarkLines)
{
    BrickAppearance appearance;
    appearance.variation = 0.0;
    const osg::ref_ptr<LegoNode> wall = createWall(appearance);
    for (const bool isOccluded : {false, true})
    {
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", wall);
        group->setEnabled(isOccluded);
        wall->setAppearance(appearance);
        const osg::ref_ptr<osg::Image> image = draw(*group, WALL_VIEW);
        // The means of columns and of rows, by their position in a brick.
        std::vector<double> columns(WALL_PIXELS);
        std::vector<double> rows(WALL_PIXELS);
        constexpr int ALL = WIDTH / WALL_PIXELS * WALL_PIXELS;
        for (int row = 0; row < HEIGHT; ++row)
            for (int column = 0; column < ALL; ++column)
            {
                const double value = brightnessAt(*image, column, row);
                columns[static_cast<std::size_t>((column + 5 * WALL_PIXELS - WIDTH / 2 % WALL_PIXELS) % WALL_PIXELS)] +=
                    value;
                rows[static_cast<std::size_t>(row % WALL_PIXELS)] += value;
            }
        for (const std::vector<double>& profile : {columns, rows})
        {
            std::vector<double> sorted = profile;
            std::sort(sorted.begin(), sorted.end());
            const double median = sorted[WALL_PIXELS / 2];
            EXPECT_LT(std::min(profile.front(), profile.back()), 0.97 * median) << "the joint";
            for (int place = 3; place < WALL_PIXELS - 3; ++place)
                EXPECT_NEAR(profile[static_cast<std::size_t>(place)], median, 0.02 * median) << place;
        }
        BrickAppearance smooth = appearance;
        smooth.joints = false;
        wall->setAppearance(smooth);
        const osg::ref_ptr<osg::Image> flat = draw(*group, WALL_VIEW);
        double least = 1.0;
        double most = 0.0;
        for (int column = 5; column < WIDTH - 5; ++column)
            for (int row = 5; row < HEIGHT - 5; ++row)
            {
                const int step = row + 1 < HEIGHT ? 1 : 0;
                const double difference = brightnessAt(*flat, column, row + step) - brightnessAt(*flat, column, row);
                least = std::min(least, difference);
                most = std::max(most, difference);
            }
        EXPECT_LT(most - least, 4.0 / 255.0) << "without joints there are no lines";
    }
}

TEST_F(BrickLook, TheReliefIsOnTheDiskOfTheStudAlone)
{
    BrickAppearance appearance;
    appearance.reliefHeight = 0.0;
    const osg::ref_ptr<LegoNode> plate = createBrickBox({10, 10, 1}, "10", GREY);
    plate->setAppearance(appearance);
    // One stud, from above, 100 pixels wide.
    const Viewpoint above{{4.5, 4.5, 20}, {4.5, 4.5, 0}, {0, 1, 0}, 1.5};
    const osg::ref_ptr<osg::Image> without = draw(*plate, above);
    appearance.reliefHeight = 0.1;
    plate->setAppearance(appearance);
    const osg::ref_ptr<osg::Image> with = draw(*plate, above);
    int count = 0;
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column)
        {
            const double difference = brightnessAt(*with, column, row) - brightnessAt(*without, column, row);
            if (std::abs(difference) < 3.0 / 255.0) continue;
            ++count;
            const double x = std::fmod((column + 0.5 - WIDTH / 2) / 100.0 + 4.5, 1.0) - 0.5;
            const double y = std::fmod((row + 0.5 - HEIGHT / 2) / 100.0 + 4.5, 1.0) - 0.5;
            ASSERT_LT(std::hypot(x, y), 0.31) << column << " " << row;
        }
    EXPECT_GT(count, 300);
}

TEST_F(BrickLook, BricksDifferAsMuchAsIsAskedForAndAlwaysInTheSameWay)
{
    BrickAppearance appearance;
    appearance.joints = false;
    const auto spread = [&](double variation)
    {
        appearance.variation = variation;
        const osg::ref_ptr<osg::Image> image = draw(*createWall(appearance), WALL_VIEW);
        // Neighbouring bricks, so that slow changes over the wall are ignored.
        double sum = 0.0;
        int count = 0;
        for (int row = WALL_PIXELS / 2; row < HEIGHT; row += WALL_PIXELS)
            for (int column = WALL_PIXELS; column + WALL_PIXELS < WIDTH; column += WALL_PIXELS, ++count)
                sum += std::abs(brightnessAt(*image, column, row) - brightnessAt(*image, column + WALL_PIXELS, row));
        return sum / count;
    };
    EXPECT_LT(spread(0.0), 1.0 / 255.0);
    EXPECT_GT(spread(1.0), 2.0 / 255.0);
    EXPECT_GT(spread(3.0), 2.0 * spread(1.0));
    const osg::ref_ptr<osg::Image> first = draw(*createWall(appearance), WALL_VIEW);
    EXPECT_EQ(countDifferent(*first, *draw(*createWall(appearance), WALL_VIEW), 0), 0u);
}

TEST_F(BrickLook, BricksSmallerThanAPixelDoNotSparkle)
{
    // 300 x 300 bricks, each of 0.7 pixels.
    const osg::ref_ptr<LegoNode> wall = createBrickBox({300, 1, 300}, "300", GREY);
    for (const bool isOccluded : {false, true})
    {
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", wall);
        group->setEnabled(isOccluded);
        const double pixel = 1.0 / 0.7;
        Viewpoint far{{150, -400, 150}, {150, 0, 150}, {0, 0, 1}, HEIGHT * pixel};
        const osg::ref_ptr<osg::Image> image = draw(*group, far);
        EXPECT_LT(stepBetweenPixels(*image), 3.0 / 255.0) << isOccluded;
        for (osg::Vec3d* place : {&far.eye, &far.target})
            *place += osg::Vec3d(0.5 * pixel, 0, 0.5 * pixel);
        EXPECT_NEAR(meanBrightness(*draw(*group, far)), meanBrightness(*image), 1.0 / 255.0) << isOccluded;
    }
}

TEST_F(BrickLook, BricksSmallerThanAPixelAreAsBrightAsLargeOnes)
{
    const osg::ref_ptr<LegoNode> plate = createBrickBox({300, 300, 1}, "300", GREY);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", plate);
    const auto measure = [&](double pixels, const osg::Vec3d& toEye)
    {
        const osg::Vec3d middle(150, 150, 0);
        const osg::ref_ptr<osg::Image> image =
            draw(*group, {middle + toEye * 400.0, middle, {0, 0, 1}, HEIGHT / pixels});
        double sum = 0.0;
        constexpr int REACH = 20;
        for (int row = -REACH; row <= REACH; ++row)
            for (int column = -REACH; column <= REACH; ++column)
                sum += brightnessAt(*image, WIDTH / 2 + column, HEIGHT / 2 + row);
        return sum / ((2 * REACH + 1) * (2 * REACH + 1));
    };
    for (const BrickOcclusion occlusion : {BrickOcclusion::OFF, BrickOcclusion::GRID, BrickOcclusion::SCREEN})
        for (const osg::Vec3d& toEye : {osg::Vec3d(0.4, -0.8, 0.45), osg::Vec3d(-0.5, 0.2, 0.85)})
        {
            BrickAppearance appearance;
            appearance.occlusion = occlusion;
            plate->setAppearance(appearance);
            group->setEnabled(occlusion == BrickOcclusion::SCREEN);
            const double near = measure(8.0, toEye);
            EXPECT_NEAR(measure(0.7, toEye), near, 0.07 * near) << static_cast<int>(occlusion) << " from " << toEye.x();
        }
}

TEST_F(BrickLook, FogHidesTheBricksInBothLooks)
{
    osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setMode(osg::Fog::LINEAR);
    fog->setStart(0.0f);
    fog->setColor(osg::Vec4(1.0f, 0.5f, 0.0f, 1.0f));
    for (const char* look : {"20,look=full", "20,look=plain"})
        for (const bool isOccluded : {false, true})
        {
            const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createWall({}, look));
            group->setEnabled(isOccluded);
            const osg::Vec3d clear = readColor(*draw(*group, WALL_VIEW), 53, 53);
            group->getOrCreateStateSet()->setAttributeAndModes(fog);
            fog->setEnd(60.0f); // the wall is halfway
            const osg::Vec3d half = readColor(*draw(*group, WALL_VIEW), 53, 53);
            EXPECT_LT((half - (clear + osg::Vec3d(1.0, 0.5, 0.0)) * 0.5).length(), 0.05) << look << isOccluded;
            fog->setEnd(20.0f);
            const osg::Vec3d all = readColor(*draw(*group, WALL_VIEW), 53, 53);
            // Bricks without the full look may be slightly occluded in a group.
            EXPECT_LT((all - osg::Vec3d(1.0, 0.5, 0.0)).length(), 0.03) << look << isOccluded;
        }
}

TEST_F(BrickLook, ThePlainLookIsDrawnInAGroup)
{
    const osg::ref_ptr<AmbientOcclusionScene> group =
        createGroup("medium", createBrickBox({8, 8, 3}, "8,look=plain", GREY));
    const Viewpoint viewpoint{{12, -18, 14}, {4, 4, 1}};
    const osg::ref_ptr<osg::Image> with = draw(*group, viewpoint);
    group->setEnabled(false);
    const osg::ref_ptr<osg::Image> without = draw(*group, viewpoint);
    EXPECT_GT(countDrawn(*with), 3000u);
    EXPECT_EQ(countDrawn(*with), countDrawn(*without));
    EXPECT_LT(meanBrightness(*with), meanBrightness(*without));
    EXPECT_GT(meanBrightness(*with), 0.7 * meanBrightness(*without));
}

TEST_F(BrickLook, AnotherLookCostsNoLegolization)
{
    const osg::ref_ptr<LegoNode> wall = createWall({});
    wall->setWaiting(true);
    const unsigned int contextID = _context->getState()->getContextID();
    const auto countLegolizations = [&] { return wall->getStatistics(contextID).numLegolizations; };
    const osg::ref_ptr<osg::Image> full = draw(*wall, WALL_VIEW);
    EXPECT_EQ(countLegolizations(), 1u);
    EXPECT_TRUE(wall->setSettings(parseSettings("20,look=plain,device=auto")));
    EXPECT_GT(countDifferent(*full, *draw(*wall, WALL_VIEW), 4), 1000u);
    EXPECT_TRUE(wall->setSettings(parseSettings("20,device=auto")));
    EXPECT_EQ(countDifferent(*full, *draw(*wall, WALL_VIEW), 0), 0u);
    BrickAppearance appearance;
    appearance.joints = false;
    EXPECT_TRUE(wall->setAppearance(appearance));
    EXPECT_GT(countDifferent(*full, *draw(*wall, WALL_VIEW), 4), 1000u);
    wall->setLightProbe(createDarkProbe());
    draw(*wall, WALL_VIEW);
    EXPECT_EQ(countLegolizations(), 1u);
    EXPECT_TRUE(wall->setSettings(parseSettings("10,device=auto")));
    draw(*wall, WALL_VIEW);
    EXPECT_EQ(countLegolizations(), 2u);
}

TEST_F(BrickLook, ABadAppearanceIsRefused)
{
    const osg::ref_ptr<LegoNode> wall = createWall({});
    BrickAppearance appearance;
    appearance.roughness = 0.0;
    EXPECT_FALSE(wall->setAppearance(appearance));
    EXPECT_EQ(wall->getAppearance(), BrickAppearance());
}

TEST_F(BrickLook, HighlightsAreTheMaterialsWhereThatIsAskedFor)
{
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setSpecular(osg::Material::FRONT_AND_BACK, osg::Vec4(1, 0, 0, 1));
    material->setShininess(osg::Material::FRONT_AND_BACK, 20.0f);
    for (const bool isOccluded : {false, true})
    {
        const osg::ref_ptr<LegoNode> wall = createBrickBox(WALL_SIZE, "20", osg::Vec4(0.1f, 0.1f, 0.1f, 1.0f));
        wall->setLightProbe(createDarkProbe());
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", wall);
        group->setLightProbe(createDarkProbe());
        group->setEnabled(isOccluded);
        group->getOrCreateStateSet()->setAttributeAndModes(material);
        // The headlight is perpendicular to the wall.
        const osg::Vec3d plastic = readColor(*draw(*group, WALL_VIEW), WIDTH / 2 + 7, HEIGHT / 2 + 7);
        EXPECT_NEAR(plastic.x(), plastic.y(), 0.02) << isOccluded;
        BrickAppearance appearance;
        appearance.materialSpecular = true;
        wall->setAppearance(appearance);
        const osg::Vec3d red = readColor(*draw(*group, WALL_VIEW), WIDTH / 2 + 7, HEIGHT / 2 + 7);
        EXPECT_GT(red.x(), 0.7) << isOccluded;
        EXPECT_LT(red.y(), 0.3) << isOccluded;
    }
}

} // namespace

} // namespace osgLego::test
