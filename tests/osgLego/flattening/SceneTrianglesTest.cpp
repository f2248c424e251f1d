#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <Meshes.h>
#include <Notices.h>
#include <Settings.h>

#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Sequence>
#include <osg/ShapeDrawable>
#include <osg/Switch>
#include <osgText/Text3D>
#include <osgText/Text>

namespace osgLego
{

namespace
{

using test::createTriangle;
using test::createUnitTriangle;
using test::noticesOf;

/** A geometry over `count` corners of a regular polygon, drawn by one primitive set. */
osg::ref_ptr<osg::Geometry> createPolygon(unsigned int count, osg::PrimitiveSet* set)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (unsigned int corner = 0; corner < count; ++corner)
        vertices->push_back(osg::Vec3(std::cos(6.28f * static_cast<float>(corner) / static_cast<float>(count)),
                                      std::sin(6.28f * static_cast<float>(corner) / static_cast<float>(count)), 0));
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(set);
    return geometry;
}

std::size_t countTriangles(osg::PrimitiveSet* set, unsigned int vertices = 8)
{
    return SceneTriangles::create(*createPolygon(vertices, set))->getNumTriangles();
}

TEST(SceneTriangles, EveryPrimitiveTypeOfTrianglesCounts)
{
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_TRIANGLES, 0, 6)), 2u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 8)), 6u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 8)), 6u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_QUADS, 0, 8)), 4u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_QUAD_STRIP, 0, 8)), 6u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_POLYGON, 0, 8)), 6u);
    osg::ref_ptr<osg::DrawElementsUByte> bytes = new osg::DrawElementsUByte(GL_TRIANGLES);
    osg::ref_ptr<osg::DrawElementsUShort> shorts = new osg::DrawElementsUShort(GL_TRIANGLE_STRIP);
    osg::ref_ptr<osg::DrawElementsUInt> ints = new osg::DrawElementsUInt(GL_QUADS);
    for (const int index : {0, 2, 4, 6})
    {
        bytes->push_back(static_cast<unsigned char>(index));
        shorts->push_back(static_cast<unsigned short>(index));
        ints->push_back(static_cast<unsigned int>(index));
    }
    EXPECT_EQ(countTriangles(bytes), 1u);
    EXPECT_EQ(countTriangles(shorts), 2u);
    EXPECT_EQ(countTriangles(ints), 2u);
    osg::ref_ptr<osg::DrawArrayLengths> lengths = new osg::DrawArrayLengths(GL_TRIANGLE_FAN, 0);
    lengths->push_back(3);
    lengths->push_back(5);
    EXPECT_EQ(countTriangles(lengths), 4u);
}

TEST(SceneTriangles, LinesAndPointsAreIgnored)
{
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_POINTS, 0, 8)), 0u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_LINES, 0, 8)), 0u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_LINE_STRIP, 0, 8)), 0u);
    EXPECT_EQ(countTriangles(new osg::DrawArrays(GL_LINE_LOOP, 0, 8)), 0u);
}

TEST(SceneTriangles, TrianglesWithIndicesOutsideTheArrayAreIgnored)
{
    osg::ref_ptr<osg::DrawElementsUInt> elements = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const unsigned int index : {0u, 1u, 2u, 0u, 1u, 4000000000u})
        elements->push_back(index);
    EXPECT_EQ(countTriangles(elements), 1u);
}

TEST(SceneTriangles, SeveralPrimitiveSetsAndDrawablesAddUp)
{
    osg::ref_ptr<osg::Geometry> geometry = createPolygon(8, new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 4, 4));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->addDrawable(new osg::ShapeDrawable(new osg::Box(osg::Vec3(), 1.0f)));
    EXPECT_EQ(SceneTriangles::create(*geode)->getNumTriangles(), 3u + 12u);
}

TEST(SceneTriangles, TransformsNestAndSharedChildrenCountAsOftenAsTheyAreShown)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(createUnitTriangle());
    osg::ref_ptr<osg::MatrixTransform> inner = new osg::MatrixTransform(osg::Matrixd::scale(2, 2, 2));
    inner->addChild(geode);
    osg::ref_ptr<osg::MatrixTransform> outer = new osg::MatrixTransform(osg::Matrixd::translate(10, 0, 0));
    outer->addChild(inner);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(outer);
    root->addChild(geode);
    const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*root);
    EXPECT_EQ(triangles->getNumTriangles(), 2u);
    EXPECT_EQ(triangles->getBounds()._min, osg::Vec3d(0, 0, 0));
    EXPECT_EQ(triangles->getBounds()._max, osg::Vec3d(12, 2, 0));
}

TEST(SceneTriangles, OnlyChildrenOfASwitchThatAreOnCount)
{
    osg::ref_ptr<osg::Switch> node = new osg::Switch;
    node->addChild(createUnitTriangle(), true);
    node->addChild(createUnitTriangle(), false);
    EXPECT_EQ(SceneTriangles::create(*node)->getNumTriangles(), 1u);
}

TEST(SceneTriangles, AHiddenNodeDoesNotCount)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createUnitTriangle());
    group->getChild(0)->setNodeMask(0);
    EXPECT_EQ(SceneTriangles::create(*group)->getNumTriangles(), 0u);
}

TEST(SceneTriangles, TheFinestLevelOfDetailCounts)
{
    for (const bool byDistance : {true, false})
    {
        osg::ref_ptr<osg::LOD> lod = new osg::LOD;
        lod->setRangeMode(byDistance ? osg::LOD::DISTANCE_FROM_EYE_POINT : osg::LOD::PIXEL_SIZE_ON_SCREEN);
        osg::ref_ptr<osg::Node> coarse = createUnitTriangle();
        osg::ref_ptr<osg::Node> fine = createPolygon(8, new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 8));
        // A level counts as the finest even if its range starts at a distance.
        lod->addChild(coarse, byDistance ? 100.0f : 0.0f, byDistance ? 1e9f : 50.0f);
        lod->addChild(fine, byDistance ? 10.0f : 50.0f, byDistance ? 100.0f : 1e9f);
        EXPECT_EQ(SceneTriangles::create(*lod)->getNumTriangles(), 6u);
    }
}

TEST(SceneTriangles, ASequenceThatHasNotStartedShowsItsFirstChild)
{
    osg::ref_ptr<osg::Sequence> sequence = new osg::Sequence;
    sequence->addChild(createUnitTriangle(), 1.0);
    sequence->addChild(createPolygon(8, new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 8)), 1.0);
    const auto countTriangles = [&] { return SceneTriangles::create(*sequence)->getNumTriangles(); };
    EXPECT_EQ(countTriangles(), 0u) << "before it is started";
    sequence->setMode(osg::Sequence::START);
    EXPECT_EQ(countTriangles(), 1u);
    sequence->setInterval(osg::Sequence::LOOP, -1, 0);
    EXPECT_EQ(countTriangles(), 6u);
    sequence->setValue(0);
    EXPECT_EQ(countTriangles(), 1u);
}

TEST(SceneTriangles, CamerasThatDrawElsewhereDoNotCount)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->addChild(createUnitTriangle());
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(camera);
    camera->setRenderOrder(osg::Camera::POST_RENDER);
    EXPECT_EQ(SceneTriangles::create(*root)->getNumTriangles(), 0u);
    camera->setRenderOrder(osg::Camera::NESTED_RENDER);
    EXPECT_EQ(SceneTriangles::create(*root)->getNumTriangles(), 1u);
}

TEST(SceneTriangles, TrianglesWithoutAreaAreIgnored)
{
    EXPECT_EQ(SceneTriangles::create(*createTriangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}))->getNumTriangles(), 0u);
    EXPECT_EQ(SceneTriangles::create(*createTriangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}))->getNumTriangles(), 0u);
}

TEST(SceneTriangles, CoordinatesThatAreNotFiniteOrTooLargeAreLeftOutAndCounted)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -2e18f})
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(createUnitTriangle());
        group->addChild(createTriangle({0, 0, 0}, {bad, 0, 0}, {0, 1, 0}));
        const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*group);
        EXPECT_EQ(triangles->getNumTriangles(), 1u);
        EXPECT_EQ(triangles->getNumBadVertices(), 1u);
        EXPECT_EQ(triangles->getNumOutOfRange(), 1u);
        EXPECT_EQ(triangles->getBounds()._max, osg::Vec3d(1, 1, 0));
    }
}

TEST(SceneTriangles, ASourceWithoutANameThatIsTooSmallIsWarnedOf)
{
    const osg::ref_ptr<osg::Geometry> tiny = createTriangle({0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0});
    const std::string notices = noticesOf([&] { SceneTriangles::create(*tiny); });
    EXPECT_EQ(notices, "osgLego: the model is smaller than 1e-18 units and is ignored; expected a larger scale\n");
}

TEST(SceneTriangles, ASourceWhosePicturesMayBeWrongIsWarnedOf)
{
    const auto noticesOfSize = [](float size)
    {
        const osg::ref_ptr<osg::Geometry> triangle = createTriangle({0, 0, 0}, {size, 0, 0}, {0, size, 0});
        return noticesOf([&] { EXPECT_EQ(SceneTriangles::create(*triangle)->getNumTriangles(), 1u); });
    };
    EXPECT_EQ(noticesOfSize(1e14f).find("osgLego: the longest side of the model is 1e+14 units, with which pictures"),
              0u);
    EXPECT_NE(noticesOfSize(1e-9f).find("expected 1e-08 to 1e+13"), std::string::npos);
    EXPECT_EQ(noticesOfSize(2e-8f), "");
    EXPECT_EQ(noticesOfSize(5e12f), "");
}

TEST(SceneTriangles, ANonFiniteVertexOfSeveralTrianglesCountsOnce)
{
    const osg::ref_ptr<osg::Geometry> fan = createPolygon(6, new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 6));
    (*dynamic_cast<osg::Vec3Array*>(fan->getVertexArray()))[2].x() = std::numeric_limits<float>::quiet_NaN();
    fan->setName("fan");
    osg::ref_ptr<const SceneTriangles> triangles;
    const std::string notices = noticesOf([&] { triangles = SceneTriangles::create(*fan); });
    EXPECT_EQ(triangles->getNumBadVertices(), 1u);
    EXPECT_EQ(triangles->getNumOutOfRange(), 2u);
    EXPECT_EQ(triangles->getNumTriangles(), 2u);
    EXPECT_EQ(notices, "osgLego: 1 vertex of 'fan' has coordinates that are not finite or beyond 1e+18; 2 triangles "
                       "with such vertices are ignored\n");
}

TEST(SceneTriangles, TrianglesTooSmallForOsgsBoundsAreIgnored)
{
    EXPECT_EQ(SceneTriangles::create(*createTriangle({0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}))->getNumTriangles(),
              0u);
    EXPECT_EQ(SceneTriangles::create(*createTriangle({0, 0, 0}, {1e-16f, 0, 0}, {0, 1e-16f, 0}))->getNumTriangles(),
              1u);
}

TEST(SceneTriangles, TrianglesBelowATransformThatIsNotFiniteAreIgnoredWithAWarning)
{
    for (const auto& [row, column] : {std::pair(0, 0), std::pair(3, 1), std::pair(3, 3)})
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        {
            osg::Matrixd matrix;
            matrix(row, column) = bad;
            osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(matrix);
            transform->addChild(createUnitTriangle());
            osg::ref_ptr<osg::Group> group = new osg::Group;
            group->addChild(transform);
            group->addChild(createTriangle({2, 0, 0}, {3, 0, 0}, {2, 1, 0}));
            osg::ref_ptr<const SceneTriangles> triangles;
            const std::string notices = noticesOf([&] { triangles = SceneTriangles::create(*group); });
            EXPECT_EQ(triangles->getNumTriangles(), 1u) << row << ' ' << column << ' ' << bad;
            EXPECT_EQ(triangles->getBounds()._min, osg::Vec3d(2, 0, 0));
            EXPECT_EQ(triangles->getNumOutOfRange(), 1u);
            EXPECT_NE(notices.find("1 triangle with such vertices is ignored"), std::string::npos) << notices;
        }
}

TEST(SceneTriangles, TextsAreIgnoredWithOneWarningForANode)
{
    const osg::ref_ptr<osgText::Text> text = new osgText::Text;
    text->setText("brick");
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setName("sign");
    group->addChild(text);
    const osg::ref_ptr<osg::MatrixTransform> board = new osg::MatrixTransform;
    board->addChild(createUnitTriangle());
    group->addChild(board);
    const std::string warning = "osgLego: 1 text of 'sign' can't be shown in bricks";
    EXPECT_EQ(SceneTriangles::create(*group)->getNumTriangles(), 1u);

    const osg::ref_ptr<LegoNode> lego = new LegoNode(test::parseSettings("8,device=cpu"));
    lego->addChild(group);
    EXPECT_NE(noticesOf([&] { lego->getBricks(); }).find("1 text"), std::string::npos);
    board->setMatrix(osg::Matrix::scale(1.0, 1.0, 2.0));
    EXPECT_EQ(noticesOf([&] { lego->getBricks(); }), "");

    std::string notices = noticesOf([&] { legolizeOnCpu(*group, test::parseSettings("8")); });
    EXPECT_EQ(notices.find(warning), 0u) << notices;
    text->setText("another");
    const osg::ref_ptr<const BrickModel> before = lego->getBricks();
    EXPECT_EQ(lego->getBricks(), before) << "a text is no part of the source";
}

TEST(SceneTriangles, TextsOfTrianglesAreLegolized)
{
    const osg::ref_ptr<osgText::Text3D> text = new osgText::Text3D;
    text->setText("brick");
    EXPECT_EQ(SceneTriangles::create(*text)->getNumTexts(), 0u);
}

TEST(SceneTriangles, ALegoNodeInASourceCountsAsItsBricks)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    LegoSettings settings;
    settings.grid.resolution = 1;
    lego->setSettings(settings);
    lego->addChild(createUnitTriangle());
    EXPECT_EQ(SceneTriangles::create(*lego)->getNumTriangles(), 1u) << "the node itself is flattened to its source";
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(lego);
    EXPECT_GT(SceneTriangles::create(*root)->getNumTriangles(), 12u);
}

} // namespace

} // namespace osgLego
