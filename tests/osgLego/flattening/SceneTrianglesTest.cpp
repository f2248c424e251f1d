#include <osgLego/LegoNode.h>
#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <Meshes.h>
#include <Notices.h>

#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/LOD>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Sequence>
#include <osg/ShapeDrawable>
#include <osg/Switch>
#include <osg/TexMat>
#include <osg/Texture2D>

namespace osgLego
{

namespace
{

using test::createTriangle;
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

glm::vec3 colorOfFirst(const osg::Node& node)
{
    const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(node);
    EXPECT_GE(triangles->getNumTriangles(), 1u);
    for (const SceneBatch& batch : triangles->getBatches())
        if (!batch.vertices.empty()) return batch.vertices.front().color;
    return glm::vec3(-1.0f);
}

osg::ref_ptr<osg::Geometry> createUnitTriangle()
{
    return createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
}

template <typename ArrayType>
osg::ref_ptr<osg::Geometry> createColored(ArrayType* colors, osg::Array::Binding binding)
{
    osg::ref_ptr<osg::Geometry> geometry = createUnitTriangle();
    geometry->setColorArray(colors, binding);
    return geometry;
}

void expectColor(const glm::vec3& color, float red, float green, float blue)
{
    EXPECT_NEAR(color.r, red, 1e-6f);
    EXPECT_NEAR(color.g, green, 1e-6f);
    EXPECT_NEAR(color.b, blue, 1e-6f);
}

osg::ref_ptr<osg::Material> createMaterial(const osg::Vec4& diffuse, osg::Material::ColorMode mode)
{
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, diffuse);
    material->setColorMode(mode);
    return material;
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

TEST(SceneTriangles, GeometryWithoutColoursIsWhite)
{
    expectColor(colorOfFirst(*createUnitTriangle()), 1, 1, 1);
}

TEST(SceneTriangles, ColourArraysThatAreOffAreIgnored)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OFF, 1);
    colors->front() = osg::Vec4(1, 0, 0, 1);
    expectColor(colorOfFirst(*createColored(colors.get(), osg::Array::BIND_OFF)), 1, 1, 1);
}

TEST(SceneTriangles, ATextureThatReleasesItsImageKeepsItsColours)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
    image->data()[0] = image->data()[1] = 255;
    image->data()[2] = 0;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    osg::ref_ptr<osg::Geometry> geometry = createUnitTriangle();
    geometry->setTexCoordArray(0, new osg::Vec2Array(3));
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    SurfaceTextureCache textures;
    const auto create = [&] { return SceneTriangles::create(*geometry, textures)->getBatches().at(0).texture; };
    const osg::ref_ptr<const SurfaceTexture> first = create();
    ASSERT_TRUE(first);
    EXPECT_EQ(create(), first);
    texture->setImage(nullptr);
    EXPECT_EQ(create(), first);
    texture->setImage(image);
    image->data()[2] = 255;
    image->dirty();
    EXPECT_NE(create(), first);
}

TEST(SceneTriangles, ColourArraysOfAnyTypeAreRead)
{
    using osg::Array;
    osg::ref_ptr<osg::Vec3Array> vec3 = new osg::Vec3Array(1);
    (*vec3)[0].set(0.2f, 0.4f, 0.6f);
    expectColor(colorOfFirst(*createColored(vec3.get(), Array::BIND_OVERALL)), 0.2f, 0.4f, 0.6f);
    osg::ref_ptr<osg::Vec4dArray> vec4d = new osg::Vec4dArray(1);
    (*vec4d)[0].set(0.2, 0.4, 1.6, 1.0);
    expectColor(colorOfFirst(*createColored(vec4d.get(), Array::BIND_OVERALL)), 0.2f, 0.4f, 1.0f);
    osg::ref_ptr<osg::Vec4ubArray> bytes = new osg::Vec4ubArray(1);
    (*bytes)[0].set(51, 102, 255, 0);
    expectColor(colorOfFirst(*createColored(bytes.get(), Array::BIND_OVERALL)), 0.2f, 0.4f, 1.0f);
    osg::ref_ptr<osg::Vec3usArray> shorts = new osg::Vec3usArray(1);
    (*shorts)[0].set(0, 65535, 13107);
    expectColor(colorOfFirst(*createColored(shorts.get(), Array::BIND_OVERALL)), 0.0f, 1.0f, 0.2f);
    osg::ref_ptr<osg::FloatArray> gray = new osg::FloatArray(1);
    (*gray)[0] = 0.5f;
    expectColor(colorOfFirst(*createColored(gray.get(), Array::BIND_OVERALL)), 0.5f, 0.0f, 0.0f);
}

TEST(SceneTriangles, ColoursBindToVerticesAndPrimitiveSets)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const float red : {0.1f, 0.5f, 0.9f})
        colors->push_back(osg::Vec4(red, 0, 0, 1));
    const osg::ref_ptr<const SceneTriangles> perVertex =
        SceneTriangles::create(*createColored(colors.get(), osg::Array::BIND_PER_VERTEX));
    const std::vector<SceneVertex>& vertices = perVertex->getBatches().front().vertices;
    for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_EQ(vertices[corner].color.r, (*colors)[corner].r());

    osg::ref_ptr<osg::Geometry> sets = createPolygon(8, new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    sets->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 4, 3));
    sets->setColorArray(colors, osg::Array::BIND_PER_PRIMITIVE_SET);
    const osg::ref_ptr<const SceneTriangles> perSet = SceneTriangles::create(*sets);
    EXPECT_EQ(perSet->getBatches().front().vertices[2].color.r, 0.1f);
    EXPECT_EQ(perSet->getBatches().front().vertices[3].color.r, 0.5f);
}

TEST(SceneTriangles, AMaterialColoursGeometryWithoutColours)
{
    osg::ref_ptr<osg::Geometry> plain = createUnitTriangle();
    plain->getOrCreateStateSet()->setAttribute(createMaterial({0.3f, 0.2f, 0.1f, 1}, osg::Material::OFF));
    expectColor(colorOfFirst(*plain), 0.3f, 0.2f, 0.1f);
    plain->getStateSet()->setAttribute(createMaterial({0.3f, 0.2f, 0.1f, 1}, osg::Material::AMBIENT_AND_DIFFUSE));
    expectColor(colorOfFirst(*plain), 0.3f, 0.2f, 0.1f);
}

TEST(SceneTriangles, AMaterialWinsOverColoursUnlessItTakesThemOrLightingIsOff)
{
    osg::ref_ptr<osg::Vec4Array> green = new osg::Vec4Array(1);
    (*green)[0].set(0, 1, 0, 1);
    osg::ref_ptr<osg::Geometry> geometry = createColored(green.get(), osg::Array::BIND_OVERALL);
    osg::StateSet* stateSet = geometry->getOrCreateStateSet();
    stateSet->setAttribute(createMaterial({1, 0, 0, 1}, osg::Material::OFF));
    expectColor(colorOfFirst(*geometry), 1, 0, 0);
    stateSet->setAttribute(createMaterial({1, 0, 0, 1}, osg::Material::DIFFUSE));
    expectColor(colorOfFirst(*geometry), 0, 1, 0);
    stateSet->setAttribute(createMaterial({1, 0, 0, 1}, osg::Material::OFF));
    stateSet->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    expectColor(colorOfFirst(*geometry), 0, 1, 0);
}

TEST(SceneTriangles, StateIsInheritedWithOverrideAndProtected)
{
    osg::ref_ptr<osg::Geometry> geometry = createUnitTriangle();
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(geometry);
    const osg::ref_ptr<osg::Material> red = createMaterial({1, 0, 0, 1}, osg::Material::OFF);
    const osg::ref_ptr<osg::Material> blue = createMaterial({0, 0, 1, 1}, osg::Material::OFF);
    group->getOrCreateStateSet()->setAttribute(red);
    expectColor(colorOfFirst(*group), 1, 0, 0);
    geometry->getOrCreateStateSet()->setAttribute(blue);
    expectColor(colorOfFirst(*group), 0, 0, 1);
    group->getStateSet()->setAttribute(red, osg::StateAttribute::OVERRIDE);
    expectColor(colorOfFirst(*group), 1, 0, 0);
    geometry->getStateSet()->setAttribute(blue, osg::StateAttribute::PROTECTED);
    expectColor(colorOfFirst(*group), 0, 0, 1);
}

/** A triangle with texture coordinates and a texture of one texel, switched on. */
osg::ref_ptr<osg::Geometry> createTextured()
{
    osg::ref_ptr<osg::Geometry> geometry = createUnitTriangle();
    osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (const float s : {0.0f, 0.5f, 1.0f})
        coordinates->push_back(osg::Vec2(s, 0.25f));
    geometry->setTexCoordArray(0, coordinates);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(image));
    return geometry;
}

TEST(SceneTriangles, TexturesComeWithTheirCoordinatesAndMatrix)
{
    osg::ref_ptr<osg::Geometry> geometry = createTextured();
    osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*geometry);
    ASSERT_TRUE(triangles->getBatches().front().texture);
    EXPECT_EQ(triangles->getBatches().front().vertices[1].coordinate, glm::vec2(0.5f, 0.25f));

    osg::ref_ptr<osg::TexMat> matrix = new osg::TexMat(osg::Matrix::scale(2, 4, 1) * osg::Matrix::translate(1, 0, 0));
    geometry->getStateSet()->setTextureAttribute(0, matrix);
    triangles = SceneTriangles::create(*geometry);
    EXPECT_EQ(triangles->getBatches().front().vertices[1].coordinate, glm::vec2(2.0f, 1.0f));
}

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
constexpr float INFINITE = std::numeric_limits<float>::infinity();

TEST(SceneTriangles, ColoursThatAreNotFiniteAreReplacedWithOneWarning)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(3);
    (*colors)[0].set(NOT_A_NUMBER, INFINITE, -INFINITE, 1);
    (*colors)[1].set(0.5f, 2.0f, -1.0f, NOT_A_NUMBER);
    (*colors)[2].set(0.25f, NOT_A_NUMBER, 0.75f, 1);
    const osg::ref_ptr<osg::Geometry> geometry = createColored(colors.get(), osg::Array::BIND_PER_VERTEX);
    geometry->setName("patch");
    osg::ref_ptr<const SceneTriangles> triangles;
    const std::string notices = noticesOf([&] { triangles = SceneTriangles::create(*geometry); });
    EXPECT_EQ(triangles->getNumTriangles(), 1u);
    EXPECT_EQ(triangles->getNumReplaced(), 2u);
    EXPECT_EQ(notices.find("osgLego: 2 vertices of 'patch' have a colour or texture coordinates that are not finite"),
              0u)
        << notices;
    const std::vector<SceneVertex>& vertices = triangles->getBatches().front().vertices;
    expectColor(vertices[0].color, 0, 1, 0);
    expectColor(vertices[1].color, 0.5f, 1, 0);
    expectColor(vertices[2].color, 0.25f, 0, 0.75f);
}

TEST(SceneTriangles, MaterialsThatAreNotFiniteAreReplaced)
{
    const osg::ref_ptr<osg::Geometry> plain = createUnitTriangle();
    const osg::ref_ptr<osg::Material> material = createMaterial({NOT_A_NUMBER, -INFINITE, 0.5f, 1}, osg::Material::OFF);
    material->setEmission(osg::Material::FRONT_AND_BACK, {0, INFINITE, INFINITE, 0});
    plain->getOrCreateStateSet()->setAttribute(material);
    expectColor(colorOfFirst(*plain), 0, 0, 1);
    osg::ref_ptr<osg::ShapeDrawable> shape = new osg::ShapeDrawable(new osg::Box(osg::Vec3(), 1.0f));
    shape->getOrCreateStateSet()->setAttribute(material);
    expectColor(colorOfFirst(*shape), 0, 0, 1);
}

TEST(SceneTriangles, TextureCoordinatesThatAreNotFiniteOrTooLargeAreReplacedWithOneWarning)
{
    for (const float bad : {NOT_A_NUMBER, INFINITE, -INFINITE, 2e18f})
    {
        const osg::ref_ptr<osg::Geometry> geometry = createTextured();
        dynamic_cast<osg::Vec2Array&>(*geometry->getTexCoordArray(0))[1].y() = bad;
        osg::ref_ptr<const SceneTriangles> triangles;
        const std::string notices = noticesOf([&] { triangles = SceneTriangles::create(*geometry); });
        EXPECT_EQ(triangles->getNumReplaced(), 1u) << bad;
        EXPECT_EQ(notices.find("osgLego: 1 vertex has a colour or texture coordinates that are not finite"), 0u);
        const std::vector<SceneVertex>& vertices = triangles->getBatches().front().vertices;
        EXPECT_EQ(vertices[1].coordinate, glm::vec2(0.0f));
        EXPECT_EQ(vertices[2].coordinate, glm::vec2(1.0f, 0.25f)) << "other vertices keep theirs";
    }
}

TEST(SceneTriangles, TextureMatricesThatAreNotFiniteGiveTheFirstTexel)
{
    for (const float bad : {NOT_A_NUMBER, INFINITE})
    {
        const osg::ref_ptr<osg::Geometry> geometry = createTextured();
        osg::Matrix matrix;
        matrix(3, 0) = bad;
        geometry->getStateSet()->setTextureAttribute(0, new osg::TexMat(matrix));
        const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*geometry);
        EXPECT_EQ(triangles->getNumReplaced(), 3u);
        for (const SceneVertex& vertex : triangles->getBatches().front().vertices)
            EXPECT_EQ(vertex.coordinate, glm::vec2(0.0f));
    }
}

TEST(SceneTriangles, TexturelessGeometryNeedsNoTextureCoordinates)
{
    const osg::ref_ptr<osg::Geometry> geometry = createTextured();
    geometry->getStateSet()->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
    dynamic_cast<osg::Vec2Array&>(*geometry->getTexCoordArray(0))[1].y() = NOT_A_NUMBER;
    EXPECT_EQ(SceneTriangles::create(*geometry)->getNumReplaced(), 0u);
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

TEST(SceneTriangles, ATextureThatIsSwitchedOffDoesNotCount)
{
    osg::ref_ptr<osg::Geometry> geometry = createTextured();
    geometry->getStateSet()->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
    EXPECT_FALSE(SceneTriangles::create(*geometry)->getBatches().front().texture);
}

TEST(SceneTriangles, TheTextureOfTheFirstUnitWithOneCounts)
{
    osg::ref_ptr<osg::Geometry> geometry = createTextured();
    osg::StateSet& state = *geometry->getStateSet();
    osg::ref_ptr<osg::StateAttribute> texture = state.getTextureAttribute(0, osg::StateAttribute::TEXTURE);
    state.removeTextureAttribute(0, texture);
    state.setTextureAttributeAndModes(2, texture);
    EXPECT_FALSE(SceneTriangles::create(*geometry)->getBatches().front().texture) << "without coordinates";

    geometry->setTexCoordArray(2, geometry->getTexCoordArray(0));
    geometry->setTexCoordArray(0, nullptr);
    state.setTextureAttribute(2, new osg::TexMat(osg::Matrix::scale(2, 4, 1)));
    osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*geometry);
    ASSERT_TRUE(triangles->getBatches().front().texture);
    EXPECT_EQ(triangles->getBatches().front().vertices[1].coordinate, glm::vec2(1.0f, 1.0f));
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
