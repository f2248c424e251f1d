#include <osgLego/BrickScene.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/LegoNode.h>

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <osg/CopyOp>
#include <osg/Geode>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>

namespace osgLego
{

namespace
{

/** Whether a node has a class of this library; all of these classes are groups. */
bool isOurs(const osg::Node& node)
{
    return node.asGroup() && std::string_view(node.libraryName()) == "osgLego";
}

using IsReplaced = bool (*)(const osg::Node&);

/** Finds the nodes to be replaced, and all nodes above them. */
class ReplacedNodes : public osg::NodeVisitor
{
public:
    ReplacedNodes(const osg::Node& scene, IsReplaced isReplaced) :
        osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _isReplaced(isReplaced)
    {
        setNodeMaskOverride(~0u);
        const_cast<osg::Node&>(scene).accept(*this); // the visitor changes nothing
    }

    bool contains(const osg::Node& node) const { return _nodes.count(&node) > 0; }

    void apply(osg::Group& group) override
    {
        const bool isLego = dynamic_cast<LegoNode*>(&group) != nullptr;
        if (_isReplaced(group)) _nodes.insert(getNodePath().begin(), getNodePath().end());
        if (!isLego) traverse(group);
    }

private:
    IsReplaced _isReplaced;
    std::set<const osg::Node*> _nodes;
};

osg::ref_ptr<osg::Geometry> createMaterialGeometry(const BrickGrid& grid, const std::vector<Brick>& bricks)
{
    osg::ref_ptr<osg::Geometry> geometry = createBrickGeometry(*BrickModel::createComplete(grid, bricks));
    const auto& color = bricks.front().color;
    const osg::Vec4 value(osg::Vec3(color[0], color[1], color[2]) / 255.0f, 1.0f);
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setAmbient(osg::Material::FRONT_AND_BACK, value);
    material->setDiffuse(osg::Material::FRONT_AND_BACK, value);
    geometry->getOrCreateStateSet()->setAttribute(material);
    geometry->setColorArray(new osg::Vec4Array(1, &value), osg::Array::BIND_OVERALL);
    return geometry;
}

osg::ref_ptr<osg::Geode> createBrickGeode(const BrickModel& model, BrickColors colors)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    if (colors == BrickColors::BY_VERTEX)
    {
        geode->addDrawable(createBrickGeometry(model));
        return geode;
    }
    std::map<std::array<std::uint8_t, 3>, std::vector<Brick>> byColor;
    for (const Brick& brick : model.getBricks())
        if (brick.openSides != 0) byColor[brick.color].push_back(brick);
    for (const auto& [color, bricks] : byColor)
        geode->addDrawable(createMaterialGeometry(model.getGrid(), bricks));
    return geode;
}

/** Move bricks to the place where a node draws them. */
osg::ref_ptr<osg::Node> placeBricks(osg::Node& bricks, const LegoNode& lego)
{
    const osg::Matrixd toNode = lego.getBricksToNode();
    if (toNode.isIdentity()) return &bricks;
    osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(toNode);
    place->addChild(&bricks);
    return place;
}

osg::ref_ptr<osg::Node> createBricks(const LegoNode& lego, BrickColors colors, const osg::CopyOp& copyop)
{
    const osg::ref_ptr<const BrickModel> model = lego.getBricks();
    if (!model) return new osg::Group(lego, copyop);
    const osg::ref_ptr<osg::Geode> geode = createBrickGeode(*model, colors);
    geode->setName(lego.getName());
    geode->setNodeMask(lego.getNodeMask());
    return placeBricks(*geode, lego);
}

bool hasBricks(const osg::Node& node)
{
    const auto* lego = dynamic_cast<const LegoNode*>(&node);
    return lego && lego->getBricks();
}

osg::ref_ptr<osg::Node> createBaked(const LegoNode& lego)
{
    osg::ref_ptr<LegoNode> baked = new LegoNode(lego);
    baked->removeChildren(0, baked->getNumChildren());
    baked->setStoredBricks(lego.getBricks().get());
    return placeBricks(*baked, lego);
}

/** Copies the nodes to be replaced, by a function, and the nodes above them. */
class SceneCopy : public osg::CopyOp
{
public:
    using Replace = std::function<osg::ref_ptr<osg::Node>(const osg::Node&, const osg::CopyOp&)>;

    SceneCopy(const osg::Node& scene, IsReplaced isReplaced, Replace replace) :
        _nodes(scene, isReplaced), _isReplaced(isReplaced), _replace(std::move(replace))
    {
    }

    using osg::CopyOp::operator();
    osg::Node* operator()(const osg::Node* node) const override
    {
        if (!node || !_nodes.contains(*node)) return const_cast<osg::Node*>(node);
        osg::ref_ptr<osg::Node>& copy = _copies[node]; // one copy, even if the node has several parents
        if (!copy && _isReplaced(*node)) copy = _replace(*node, *this);
        if (!copy) copy = static_cast<osg::Node*>(node->clone(*this));
        return copy;
    }

private:
    ReplacedNodes _nodes;
    IsReplaced _isReplaced;
    Replace _replace;
    mutable std::map<const osg::Node*, osg::ref_ptr<osg::Node>> _copies;
};

} // namespace

osg::ref_ptr<const osg::Node> createBrickScene(const osg::Node& scene, BrickColors colors)
{
    const auto replace = [colors](const osg::Node& node, const osg::CopyOp& copyop) -> osg::ref_ptr<osg::Node>
    {
        if (const auto* lego = dynamic_cast<const LegoNode*>(&node)) return createBricks(*lego, colors, copyop);
        return new osg::Group(*node.asGroup(), copyop);
    };
    return SceneCopy(scene, isOurs, replace)(&scene);
}

osg::ref_ptr<const osg::Node> createBakedScene(const osg::Node& scene)
{
    const auto replace = [](const osg::Node& node, const osg::CopyOp&)
    { return createBaked(dynamic_cast<const LegoNode&>(node)); };
    return SceneCopy(scene, hasBricks, replace)(&scene);
}

} // namespace osgLego
