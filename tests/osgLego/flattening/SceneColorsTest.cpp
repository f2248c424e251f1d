#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <Meshes.h>
#include <Notices.h>

#include <limits>

#include <gtest/gtest.h>
#include <osg/Material>
#include <osg/ShapeDrawable>
#include <osg/TexMat>
#include <osg/Texture2D>

namespace osgLego
{

namespace
{

using test::createUnitTriangle;
using test::noticesOf;

glm::vec3 colorOfFirst(const osg::Node& node)
{
    const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(node);
    EXPECT_GE(triangles->getNumTriangles(), 1u);
    for (const SceneBatch& batch : triangles->getBatches())
        if (!batch.vertices.empty()) return batch.vertices.front().color;
    return glm::vec3(-1.0f);
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

TEST(SceneColors, GeometryWithoutColoursIsWhite)
{
    expectColor(colorOfFirst(*createUnitTriangle()), 1, 1, 1);
}

TEST(SceneColors, ColourArraysThatAreOffAreIgnored)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OFF, 1);
    colors->front() = osg::Vec4(1, 0, 0, 1);
    expectColor(colorOfFirst(*createColored(colors.get(), osg::Array::BIND_OFF)), 1, 1, 1);
}

TEST(SceneColors, ATextureThatReleasesItsImageKeepsItsColours)
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

TEST(SceneColors, ColourArraysOfAnyTypeAreRead)
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

TEST(SceneColors, ColoursBindToVerticesAndPrimitiveSets)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const float red : {0.1f, 0.5f, 0.9f})
        colors->push_back(osg::Vec4(red, 0, 0, 1));
    const osg::ref_ptr<const SceneTriangles> perVertex =
        SceneTriangles::create(*createColored(colors.get(), osg::Array::BIND_PER_VERTEX));
    const std::vector<SceneVertex>& vertices = perVertex->getBatches().front().vertices;
    for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_EQ(vertices[corner].color.r, (*colors)[corner].r());

    const osg::ref_ptr<osg::Geometry> sets = createUnitTriangle();
    sets->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    sets->setColorArray(colors, osg::Array::BIND_PER_PRIMITIVE_SET);
    const osg::ref_ptr<const SceneTriangles> perSet = SceneTriangles::create(*sets);
    EXPECT_EQ(perSet->getBatches().front().vertices[2].color.r, 0.1f);
    EXPECT_EQ(perSet->getBatches().front().vertices[3].color.r, 0.5f);
}

TEST(SceneColors, AMaterialColoursGeometryWithoutColours)
{
    osg::ref_ptr<osg::Geometry> plain = createUnitTriangle();
    plain->getOrCreateStateSet()->setAttribute(createMaterial({0.3f, 0.2f, 0.1f, 1}, osg::Material::OFF));
    expectColor(colorOfFirst(*plain), 0.3f, 0.2f, 0.1f);
    plain->getStateSet()->setAttribute(createMaterial({0.3f, 0.2f, 0.1f, 1}, osg::Material::AMBIENT_AND_DIFFUSE));
    expectColor(colorOfFirst(*plain), 0.3f, 0.2f, 0.1f);
}

TEST(SceneColors, AMaterialWinsOverColoursUnlessItTakesThemOrLightingIsOff)
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

TEST(SceneColors, StateIsInheritedWithOverrideAndProtected)
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

TEST(SceneColors, TexturesComeWithTheirCoordinatesAndMatrix)
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

TEST(SceneColors, ColoursThatAreNotFiniteAreReplacedWithOneWarning)
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

TEST(SceneColors, MaterialsThatAreNotFiniteAreReplaced)
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

TEST(SceneColors, TextureCoordinatesThatAreNotFiniteOrTooLargeAreReplacedWithOneWarning)
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

TEST(SceneColors, TextureMatricesThatAreNotFiniteGiveTheFirstTexel)
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

TEST(SceneColors, TexturelessGeometryNeedsNoTextureCoordinates)
{
    const osg::ref_ptr<osg::Geometry> geometry = createTextured();
    geometry->getStateSet()->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
    dynamic_cast<osg::Vec2Array&>(*geometry->getTexCoordArray(0))[1].y() = NOT_A_NUMBER;
    EXPECT_EQ(SceneTriangles::create(*geometry)->getNumReplaced(), 0u);
}

TEST(SceneColors, ATextureThatIsSwitchedOffDoesNotCount)
{
    osg::ref_ptr<osg::Geometry> geometry = createTextured();
    geometry->getStateSet()->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
    EXPECT_FALSE(SceneTriangles::create(*geometry)->getBatches().front().texture);
}

TEST(SceneColors, TheTextureOfTheFirstUnitWithOneCounts)
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

} // namespace

} // namespace osgLego
