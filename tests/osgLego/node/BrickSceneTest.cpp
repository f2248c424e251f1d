#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/BrickGeometry.h>
#include <osgLego/BrickScene.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Switch>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<LegoNode> createLego()
{
    LegoSettings settings;
    settings.grid.resolution = 8;
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->setName("ball");
    lego->setNodeMask(0xf0);
    lego->addChild(createSphere(6));
    return lego;
}

/** The geode that replaces a LegoNode, in a scene that consists only of the path to it. */
const osg::Geode* findGeode(const osg::Node* node)
{
    while (const osg::Group* group = node->asGroup())
    {
        if (dynamic_cast<const LegoNode*>(group)) return nullptr; // not replaced
        if (const osg::Geode* geode = group->asGeode()) return geode;
        if (group->getNumChildren() == 0) return nullptr;
        node = group->getChild(0);
    }
    return nullptr;
}

unsigned int countTriangles(const osg::Geode& geode)
{
    unsigned int count = 0;
    for (unsigned int index = 0; index < geode.getNumDrawables(); ++index)
        count += geode.getDrawable(index)->asGeometry()->getPrimitiveSet(0)->getNumIndices() / 3;
    return count;
}

TEST(BrickScene, ANodeBecomesAGeodeWithItsNameAndMask)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    const unsigned int expected = createBrickGeometry(*lego->getBricks())->getPrimitiveSet(0)->getNumIndices() / 3;
    for (const BrickColors colors : {BrickColors::BY_VERTEX, BrickColors::BY_MATERIAL})
    {
        const osg::ref_ptr<const osg::Node> scene = createBrickScene(*lego, colors);
        const osg::Geode* geode = findGeode(scene);
        ASSERT_TRUE(geode);
        EXPECT_EQ(geode->getName(), "ball");
        EXPECT_EQ(geode->getNodeMask(), 0xf0u);
        EXPECT_EQ(countTriangles(*geode), expected);
        EXPECT_EQ(geode->getBoundingBox()._max, osg::Vec3(lego->getBricks()->getGrid().getBrickBounds()._max));
    }
}

TEST(BrickScene, EachColorHasOneGeometryAndItsMaterial)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    std::set<std::array<std::uint8_t, 3>> expected;
    for (const Brick& brick : lego->getBricks()->getBricks())
        if (brick.openSides != 0) expected.insert(brick.color);
    const osg::ref_ptr<const osg::Node> scene = createBrickScene(*lego, BrickColors::BY_MATERIAL);
    const osg::Geode& geode = *findGeode(scene);
    ASSERT_EQ(geode.getNumDrawables(), expected.size());
    for (unsigned int index = 0; index < geode.getNumDrawables(); ++index)
    {
        const auto* material = dynamic_cast<const osg::Material*>(
            geode.getDrawable(index)->getStateSet()->getAttribute(osg::StateAttribute::MATERIAL));
        ASSERT_TRUE(material);
        std::array<std::uint8_t, 3> color{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            color[channel] = static_cast<std::uint8_t>(
                std::lround(255.0f * material->getDiffuse(osg::Material::FRONT)[static_cast<int>(channel)]));
        EXPECT_EQ(expected.erase(color), 1u);
    }
}

TEST(BrickScene, OnlyNodesAboveBricksAreCopied)
{
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(osg::Matrix::translate(1, 2, 3));
    transform->addChild(createLego());
    osg::ref_ptr<osg::Switch> other = new osg::Switch;
    other->addChild(createSphere(4), false);
    osg::ref_ptr<AmbientOcclusionScene> occlusion = new AmbientOcclusionScene;
    occlusion->setName("scene");
    occlusion->addChild(transform);
    occlusion->addChild(other);

    const osg::ref_ptr<const osg::Node> scene = createBrickScene(*occlusion, BrickColors::BY_VERTEX);
    EXPECT_STREQ(scene->className(), "Group");
    EXPECT_EQ(scene->getName(), "scene");
    const osg::Group& group = *scene->asGroup();
    ASSERT_EQ(group.getNumChildren(), 2u);
    EXPECT_EQ(group.getChild(1), other);
    ASSERT_TRUE(group.getChild(0)->asTransform());
    EXPECT_NE(group.getChild(0), transform);
    EXPECT_EQ(group.getChild(0)->asTransform()->asMatrixTransform()->getMatrix(), transform->getMatrix());
    EXPECT_TRUE(findGeode(group.getChild(0)));
    EXPECT_TRUE(dynamic_cast<LegoNode*>(transform->getChild(0))) << "the original must not change";
}

TEST(BrickScene, ANodeWithSeveralParentsStaysShared)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (int parent = 0; parent < 2; ++parent)
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(lego);
        scene->addChild(group);
    }
    const osg::ref_ptr<const osg::Node> copy = createBrickScene(*scene, BrickColors::BY_VERTEX);
    EXPECT_EQ(findGeode(copy->asGroup()->getChild(0)), findGeode(copy->asGroup()->getChild(1)));
}

TEST(BrickScene, HiddenBricksAreReplacedToo)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    osg::ref_ptr<osg::Switch> scene = new osg::Switch;
    scene->setNodeMask(0);
    scene->addChild(lego, false);
    const osg::ref_ptr<const osg::Node> copy = createBrickScene(*scene, BrickColors::BY_VERTEX);
    EXPECT_TRUE(findGeode(copy));
    EXPECT_EQ(copy->getNodeMask(), 0u);
}

TEST(BakedScene, ANodeKeepsItsBricksAndLookWithoutItsSource)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    BrickAppearance appearance;
    appearance.joints = false;
    lego->setAppearance(appearance);
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->addChild(lego);

    const osg::ref_ptr<const osg::Node> baked = createBakedScene(*scene);
    ASSERT_NE(baked, scene);
    ASSERT_TRUE(dynamic_cast<const AmbientOcclusionScene*>(baked.get()));
    const auto* bakedLego = dynamic_cast<const LegoNode*>(baked->asGroup()->getChild(0));
    ASSERT_TRUE(bakedLego);
    EXPECT_EQ(bakedLego->getNumChildren(), 0u);
    EXPECT_EQ(bakedLego->getStoredBricks(), lego->getBricks());
    EXPECT_EQ(bakedLego->getSettings(), lego->getSettings());
    EXPECT_EQ(bakedLego->getAppearance(), appearance);
    EXPECT_EQ(bakedLego->getName(), "ball");
    EXPECT_EQ(bakedLego->getNodeMask(), 0xf0u);
    EXPECT_EQ(lego->getNumChildren(), 1u) << "the original must not change";
    EXPECT_FALSE(lego->getStoredBricks());

    const osg::ref_ptr<const osg::Node> again = createBakedScene(*baked);
    EXPECT_EQ(dynamic_cast<const LegoNode&>(*again->asGroup()->getChild(0)).getStoredBricks(), lego->getBricks());
}

TEST(BakedScene, WithoutTrianglesANodeKeepsItsSource)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->addChild(new osg::Group);
    EXPECT_EQ(createBakedScene(*lego), lego);
    const osg::ref_ptr<osg::Node> sphere = createSphere(4);
    EXPECT_EQ(createBakedScene(*sphere), sphere);
}

TEST(BrickScene, StoredBricksBecomeAGeode)
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    const osg::ref_ptr<const osg::Node> baked = createBakedScene(*lego);
    const osg::ref_ptr<const osg::Node> scene = createBrickScene(*baked, BrickColors::BY_VERTEX);
    const osg::ref_ptr<const osg::Node> expected = createBrickScene(*lego, BrickColors::BY_VERTEX);
    ASSERT_TRUE(findGeode(scene));
    EXPECT_EQ(countTriangles(*findGeode(scene)), countTriangles(*findGeode(expected)));
}

TEST(BrickScene, WithoutBricksTheSceneIsTheSame)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere(4);
    EXPECT_EQ(createBrickScene(*sphere, BrickColors::BY_VERTEX), sphere);
    const osg::ref_ptr<LegoNode> empty = new LegoNode;
    const osg::ref_ptr<const osg::Node> copy = createBrickScene(*empty, BrickColors::BY_VERTEX);
    EXPECT_STREQ(copy->className(), "Group");
}

} // namespace

} // namespace osgLego::test
