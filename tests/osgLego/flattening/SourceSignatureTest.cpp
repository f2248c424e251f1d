#include <osgLego/flattening/SourceSignature.h>

#include <Meshes.h>

#include <gtest/gtest.h>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osg/Texture2D>

namespace osgLego
{

namespace
{

class SourceSignatureTest : public ::testing::Test
{
protected:
    SourceSignatureTest()
    {
        _geometry = test::createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        _geometry->setTexCoordArray(0, new osg::Vec2Array(3));
        _switch->addChild(_geometry);
        _transform->addChild(_switch);
    }

    /** Whether `change` is noticed. */
    template <typename Change>
    bool notices(const Change& change)
    {
        const SourceSignature before = computeSourceSignature(*_transform);
        EXPECT_TRUE(computeSourceSignature(*_transform) == before) << "nothing changed";
        change();
        return !(computeSourceSignature(*_transform) == before);
    }

    osg::Vec3Array& getVertices() { return static_cast<osg::Vec3Array&>(*_geometry->getVertexArray()); }

    osg::ref_ptr<osg::MatrixTransform> _transform = new osg::MatrixTransform;
    osg::ref_ptr<osg::Switch> _switch = new osg::Switch;
    osg::ref_ptr<osg::Geometry> _geometry;
};

TEST_F(SourceSignatureTest, NoticesTransforms)
{
    EXPECT_TRUE(notices([&] { _transform->setMatrix(osg::Matrix::translate(0, 0, 1e-3)); }));
}

TEST_F(SourceSignatureTest, NoticesSwitches)
{
    EXPECT_TRUE(notices([&] { _switch->setAllChildrenOff(); }));
}

TEST_F(SourceSignatureTest, NoticesAddedAndRemovedNodes)
{
    EXPECT_TRUE(notices([&] { _switch->addChild(test::createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})); }));
    EXPECT_TRUE(notices([&] { _switch->removeChild(0u, 1u); }));
}

TEST_F(SourceSignatureTest, NoticesANodeThatReplacesAnother)
{
    // Many, so that some new nodes reuse the address of a deleted one.
    for (int repeat = 0; repeat < 100; ++repeat)
        EXPECT_TRUE(notices(
            [&]
            {
                _switch->removeChild(0u, 1u);
                _geometry = nullptr;
                _geometry = test::createTriangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
                _switch->addChild(_geometry);
            }));
}

TEST_F(SourceSignatureTest, NoticesArraysMarkedDirty)
{
    EXPECT_TRUE(notices(
        [&]
        {
            getVertices()[0].z() = 1.0f;
            getVertices().dirty();
        }));
}

TEST_F(SourceSignatureTest, NoticesArraysOfADynamicGeometryWithoutDirty)
{
    EXPECT_FALSE(notices([&] { getVertices()[0].z() = 1.0f; }));
    _geometry->setDataVariance(osg::Object::DYNAMIC);
    EXPECT_TRUE(notices([&] { getVertices()[0].z() = 2.0f; }));
}

TEST_F(SourceSignatureTest, NoticesPrimitiveSets)
{
    EXPECT_TRUE(notices([&] { static_cast<osg::DrawArrays*>(_geometry->getPrimitiveSet(0))->setCount(0); }));
}

TEST_F(SourceSignatureTest, NoticesMaterials)
{
    osg::ref_ptr<osg::Material> material = new osg::Material;
    EXPECT_TRUE(notices([&] { _switch->getOrCreateStateSet()->setAttribute(material); }));
    EXPECT_TRUE(notices([&] { material->setDiffuse(osg::Material::FRONT, osg::Vec4(1, 0, 0, 1)); }));
}

TEST_F(SourceSignatureTest, NoticesTexturesAndTheirImages)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    EXPECT_TRUE(notices([&] { _switch->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture); }));
    EXPECT_TRUE(notices([&] { image->dirty(); }));
    EXPECT_TRUE(notices([&] { texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT); }));
}

} // namespace

} // namespace osgLego
