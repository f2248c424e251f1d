#include <LookTest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <osg/Geode>
#include <osg/Shape>
#include <osg/ShapeDrawable>

namespace osgLego::test
{

namespace
{

const osg::Vec4 BALL_COLOR(1.0f, 1.0f, 1.0f, 1.0f);

double levelOf(const osg::Vec3d& color)
{
    return 255.0 * (color.x() + color.y() + color.z()) / 3.0;
}

/** The levels, 0 to 255, of the drawn pixels, in ascending order. */
std::vector<double> sortedLevels(const osg::Image& image)
{
    std::vector<double> levels;
    for (int row = 0; row < image.t(); ++row)
        for (int column = 0; column < image.s(); ++column)
        {
            const osg::Vec3d color = readColor(image, column, row);
            if (color != readColor(image, 0, 0)) levels.push_back(levelOf(color));
        }
    std::sort(levels.begin(), levels.end());
    return levels;
}

double quantileOf(const std::vector<double>& sorted, double share)
{
    return sorted.at(static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1)));
}

/** Bricks as osgviewer shows them: in a group, lit by the built-in sky and the headlight of a viewer. */
class BrickLight : public LookTest
{
protected:
    static osg::ref_ptr<AmbientOcclusionScene> createBall(const std::string& settings,
                                                          BrickOcclusion occlusion = BrickOcclusion::SCREEN)
    {
        osg::ref_ptr<osg::ShapeDrawable> ball = new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(), 10.0f));
        ball->setColor(BALL_COLOR);
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(ball);
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings + ",device=cpu"));
        lego->addChild(geode);
        BrickAppearance appearance;
        appearance.occlusion = occlusion;
        lego->setAppearance(appearance);
        return createGroup("medium", lego);
    }

    /** The colour of a face of a box of 4 x 4 x 4 bricks, seen from a distance. */
    osg::Vec3d faceOf(const osg::Vec4& color, const osg::Vec3d& toEye, const osg::Vec3d& face)
    {
        const osg::ref_ptr<osg::Node> group = createGroup("medium", createBrickBox({4, 4, 4}, "4", color));
        const osg::Vec3d middle(2, 2, 2);
        const osg::ref_ptr<osg::Image> image = draw(*group, {middle + toEye * 20.0, middle});
        // Between four studs, and the centre of a brick next to the centre.
        osg::Vec3d place = middle + face * 2.0;
        for (int axis = 0; axis < 3; ++axis)
            if (face[axis] == 0.0) place[axis] += face.z() > 0.5 ? 0.1 : 0.5;
        return colorAt(*image, place);
    }
};

TEST_F(BrickLight, AWhiteMeshBeforeAHeadlightShowsItsShape)
{
    const osg::ref_ptr<AmbientOcclusionScene> ball = createBall("40");
    const std::vector<double> levels = sortedLevels(*draw(*ball, {{0, -45, 0}, {0, 0, 0}}));
    ASSERT_GT(levels.size(), 8000u);
    EXPECT_LT(quantileOf(levels, 0.99), 245.0);
    EXPECT_GT(quantileOf(levels, 0.9) - quantileOf(levels, 0.1), 50.0);
    EXPECT_GT(quantileOf(levels, 0.5), 180.0) << "white is not grey";
}

TEST_F(BrickLight, TopFrontAndSideOfABrickAreToldApart)
{
    for (const osg::Vec3d& toEye : {osg::Vec3d(0.4, -0.8, 0.45), osg::Vec3d(0.5, -0.7, 0.6),
                                    osg::Vec3d(-0.5, -0.7, 0.6), osg::Vec3d(0.6, -0.6, 0.4)})
    {
        const double top = levelOf(faceOf(BALL_COLOR, toEye, {0, 0, 1}));
        const double front = levelOf(faceOf(BALL_COLOR, toEye, {0, -1, 0}));
        const double side = levelOf(faceOf(BALL_COLOR, toEye, {toEye.x() > 0.0 ? 1.0 : -1.0, 0, 0}));
        EXPECT_GT(top - front, 22.0) << toEye.x();
        EXPECT_GT(front - side, 25.0) << toEye.x();
        EXPECT_LT(top, 245.0) << toEye.x();
    }
}

TEST_F(BrickLight, BlackStaysBlackAndRedStaysRed)
{
    const osg::Vec4 black(0.094f, 0.094f, 0.1f, 1.0f);
    const osg::Vec4 red(0.8f, 0.094f, 0.11f, 1.0f);
    for (const osg::Vec3d& toEye : {osg::Vec3d(0, -1, 0), osg::Vec3d(0.4, -0.8, 0.45)})
    {
        EXPECT_LT(levelOf(faceOf(black, toEye, {0, -1, 0})), 42.0) << toEye.x();
        const osg::Vec3d color = faceOf(red, toEye, {0, -1, 0});
        EXPECT_GT(color.x(), 0.6) << toEye.x();
        EXPECT_LT(std::max(color.y(), color.z()), 0.18) << toEye.x();
    }
}

/** The range of the levels of each pixel over several pictures of a ball that fills them, except near its silhouette.
 */
double flickerOf(const std::vector<osg::ref_ptr<osg::Image>>& images)
{
    constexpr int RADIUS = 40;
    double squares = 0.0;
    int count = 0;
    for (int y = -RADIUS; y <= RADIUS; ++y)
        for (int x = -RADIUS; x <= RADIUS; ++x)
        {
            if (x * x + y * y > RADIUS * RADIUS) continue;
            std::vector<double> levels;
            for (const osg::ref_ptr<osg::Image>& image : images)
                levels.push_back(levelOf(readColor(*image, GlTest::WIDTH / 2 + x, GlTest::HEIGHT / 2 + y)));
            const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
            squares += (*most - *least) * (*most - *least);
            ++count;
        }
    return std::sqrt(squares / count);
}

TEST_F(BrickLight, DistantBricksDoNotFlickerAsTheCameraMoves)
{
    /** The most flicker without an AmbientOcclusionScene, and below one. */
    struct Limits
    {
        BrickOcclusion occlusion;
        double alone;
        double below;
    };
    // Distant occlusion of the grid, in finer voxels than that of an AmbientOcclusionScene, contrasts faces a little
    // more below one. Without any occlusion, sides are brighter.
    for (const char* settings : {"150", "300"})
        for (const Limits& limits :
             {Limits{BrickOcclusion::SCREEN, 24.0, 8.0}, Limits{BrickOcclusion::GRID, 25.5, 23.5}})
            for (const bool isBelow : {false, true})
            {
                const osg::ref_ptr<AmbientOcclusionScene> ball = createBall(settings, limits.occlusion);
                ball->setEnabled(isBelow);
                std::vector<osg::ref_ptr<osg::Image>> images;
                for (const double shift : {0.0, 0.07, 0.14, 0.21})
                {
                    // Bricks of 0.6 and of 0.3 pixels with visible faces of all kinds; each picture is shifted by a
                    // fraction of a pixel.
                    const osg::Vec3d target = osg::Vec3d(0.5, 0.3, 0.8) * shift;
                    images.push_back(draw(*ball, {target + osg::Vec3d(20, -35, 25), target, {0, 0, 1}, 33.0}));
                }
                EXPECT_LT(flickerOf(images), isBelow ? limits.below : limits.alone)
                    << settings << (limits.occlusion == BrickOcclusion::GRID ? ", grid" : ", screen") << isBelow;
            }
}

} // namespace

} // namespace osgLego::test
