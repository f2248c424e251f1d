#include "InstancedGltf.h"

#include <osgLego/BrickScene.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <Notices.h>
#include <PartModels.h>
#include <Settings.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

using GltfColor = std::array<std::uint8_t, 3>;
/** The corners of a box, in ten-thousandths of a cell, and its colour: in an order. */
using BoxKey = std::tuple<std::array<long, 6>, std::array<int, 3>>;

BoxKey toKey(const osg::BoundingBoxd& bounds, const std::array<int, 3>& color)
{
    std::array<long, 6> corners{};
    for (int axis = 0; axis < 3; ++axis)
    {
        corners[static_cast<std::size_t>(axis)] = std::lround(10000.0 * bounds._min[axis]);
        corners[static_cast<std::size_t>(axis) + 3] = std::lround(10000.0 * bounds._max[axis]);
    }
    return {corners, color};
}

/** The boxes that parts have in a world to which a transform leads. */
std::vector<BoxKey> expectedBoxes(const BrickModel& model, const osg::Matrixd& toWorld = {})
{
    const BrickGrid& grid = model.getGrid();
    const int up = grid.getUpIndex();
    std::vector<Part> parts = model.getParts();
    if (parts.empty())
        for (const Brick& brick : model.getBricks())
            parts.push_back({brick.cell, {1, 1, 1}, brick.color, Part::NO_CODE});
    std::vector<BoxKey> boxes;
    for (const Part& part : parts)
    {
        osg::BoundingBoxd own;
        for (int axis = 0; axis < 3; ++axis)
        {
            const double gap = axis == up ? 0.0 : 0.014 * grid.cellSize[axis];
            const double stud = axis == up ? 0.2125 * grid.cellSize.x : 0.0;
            const double lowest = grid.origin[axis] + grid.cellSize[axis] * part.getCell()[axis];
            own._min[axis] = lowest + gap;
            own._max[axis] = lowest + grid.cellSize[axis] * part.getSize()[axis] - gap + stud;
        }
        osg::BoundingBoxd bounds;
        for (unsigned int corner = 0; corner < 8; ++corner)
            bounds.expandBy(own.corner(corner) * toWorld);
        boxes.push_back(toKey(bounds, {part.color[0], part.color[1], part.color[2]}));
    }
    std::sort(boxes.begin(), boxes.end());
    return boxes;
}

std::vector<BoxKey> sortedBoxes(const InstancedGltf& file)
{
    std::vector<BoxKey> boxes;
    for (const InstancedGltf::Box& box : file.getBoxes())
        boxes.push_back(toKey(box.bounds, box.color));
    std::sort(boxes.begin(), boxes.end());
    return boxes;
}

osg::ref_ptr<const BrickModel> createColoredParts(const glm::ivec3& dimensions, UpAxis up = UpAxis::Z)
{
    PartFilling filling;
    filling.colors = {{200, 30, 0}, {255, 255, 255}, {1, 130, 77}};
    filling.isCovered = [](const glm::ivec3& cell) { return (cell.x + cell.y + cell.z) % 7 != 0; };
    return createParts(createPartGrid(dimensions, 1.2, up), filling);
}

/** Collects the boxes of the geodes of a scene, with their colours. */
class GeodeBoxes : public osg::NodeVisitor
{
public:
    GeodeBoxes() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    using osg::NodeVisitor::apply;
    void apply(osg::Geode& geode) override
    {
        const osg::Matrixd toWorld = osg::computeLocalToWorld(getNodePath());
        osg::BoundingBoxd bounds;
        for (unsigned int corner = 0; corner < 8; ++corner)
            bounds.expandBy(osg::Vec3d(geode.getBoundingBox().corner(corner)) * toWorld);
        const osg::Geometry& geometry = *geode.getDrawable(0)->asGeometry();
        const osg::Vec4 color = dynamic_cast<const osg::Vec4Array&>(*geometry.getColorArray())[0] * 255.0f;
        boxes.push_back(
            toKey(bounds, {static_cast<int>(std::lround(color.r())), static_cast<int>(std::lround(color.g())),
                           static_cast<int>(std::lround(color.b()))}));
    }

    std::vector<BoxKey> boxes;
};

class GltfWriter : public TemporaryFolderTest
{
protected:
    InstancedGltf write(const osg::Node& scene) const
    {
        EXPECT_TRUE(osgDB::writeNodeFile(scene, pathOf("bricks.glb")));
        return InstancedGltf(contentsOf(pathOf("bricks.glb")));
    }

    std::string errorOf(const osg::Node& scene) const
    {
        const auto result = osgDB::Registry::instance()->writeNode(scene, pathOf("bricks.glb"), nullptr);
        EXPECT_FALSE(result.success());
        return result.statusMessage();
    }
};

TEST_F(GltfWriter, HoldsAnInstanceForEachPartInItsPlaceAndColour)
{
    const osg::ref_ptr<const BrickModel> model = createColoredParts({9, 7, 4});
    ASSERT_GT(model->getParts().size(), 20u);
    EXPECT_EQ(sortedBoxes(write(*createStoredNode(*model, "parts=bricks"))), expectedBoxes(*model));
}

TEST_F(GltfWriter, HoldsAnInstanceForEachCellOfAModelWithoutParts)
{
    const osg::ref_ptr<const BrickModel> model = createCells(*createColoredParts({5, 4, 3}));
    ASSERT_EQ(model->getParts().size(), 0u);
    EXPECT_EQ(sortedBoxes(write(*createStoredNode(*model, "16"))), expectedBoxes(*model));
}

TEST_F(GltfWriter, PlacesPartsOfModelsWithYUpwards)
{
    const osg::ref_ptr<const BrickModel> model = createColoredParts({7, 3, 9}, UpAxis::Y);
    EXPECT_EQ(sortedBoxes(write(*createStoredNode(*model, "parts=bricks"))), expectedBoxes(*model));
}

TEST_F(GltfWriter, PlacesPartsBelowTransforms)
{
    const osg::ref_ptr<const BrickModel> model = createColoredParts({5, 4, 3});
    const osg::Matrixd turn(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1); // a quarter turn, twice as large
    const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(turn);
    const osg::ref_ptr<LegoNode> lego = createStoredNode(*model, "parts=bricks");
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    transform->addChild(lego);
    scene->addChild(lego);
    scene->addChild(transform);
    const InstancedGltf file = write(*scene);
    std::vector<BoxKey> expected = expectedBoxes(*model);
    const std::vector<BoxKey> turned = expectedBoxes(*model, turn);
    expected.insert(expected.end(), turned.begin(), turned.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(sortedBoxes(file), expected);
    // The triangles and places of the node are in the file once.
    EXPECT_EQ(file.getAll("accessors").size(), write(*lego).getAll("accessors").size());
}

TEST_F(GltfWriter, PlacesPartsInALatticeOfTheWorld)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("cell=0.4,anchor=world,parts=bricks"));
    lego->addChild(createSphere(8));
    const osg::ref_ptr<osg::MatrixTransform> above =
        new osg::MatrixTransform(osg::Matrixd(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1));
    above->addChild(lego);
    EXPECT_EQ(sortedBoxes(write(*above)), expectedBoxes(*lego->getBricks()));
}

TEST_F(GltfWriter, WritesFilesThatTheReaderTurnsIntoTheSameParts)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    {
        const osg::ref_ptr<const BrickModel> model = createColoredParts({9, 7, 4}, up);
        write(*createStoredNode(*model, "parts=bricks"));
        const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(pathOf("bricks.glb"));
        ASSERT_TRUE(back);
        GeodeBoxes visitor;
        back->accept(visitor);
        std::sort(visitor.boxes.begin(), visitor.boxes.end());
        EXPECT_EQ(visitor.boxes, expectedBoxes(*model));
    }
}

TEST_F(GltfWriter, StoresTheTrianglesOfEachShapeOnce)
{
    const osg::ref_ptr<const BrickModel> model = createColoredParts({9, 7, 4});
    std::set<std::pair<int, int>> shapes;
    std::set<std::tuple<int, int, GltfColor>> colored;
    for (const Part& part : model->getParts())
    {
        const auto [width, length] = std::minmax(part.size[0], part.size[1]);
        shapes.emplace(width, length);
        colored.emplace(width, length, part.color);
    }
    const InstancedGltf file = write(*createStoredNode(*model, "parts=bricks"));
    std::set<std::int64_t> positions;
    for (const JsonValue& mesh : file.getAll("meshes"))
        positions.insert(mesh["primitives"].getElements().at(0)["attributes"]["POSITION"].toInteger());
    EXPECT_EQ(positions.size(), shapes.size());
    EXPECT_EQ(file.getAll("meshes").size(), colored.size());
    EXPECT_EQ(file.getAll("materials").size(), 3u);
}

TEST_F(GltfWriter, HasNormalsThatPointOutwards)
{
    const osg::ref_ptr<const BrickModel> model = createColoredParts({9, 7, 4});
    const InstancedGltf file = write(*createStoredNode(*model, "parts=bricks"));
    for (const JsonValue& mesh : file.getAll("meshes"))
    {
        const JsonValue& primitive = mesh["primitives"].getElements().at(0);
        const auto vertices = file.getVectors(primitive["attributes"]["POSITION"]);
        const auto normals = file.getVectors(primitive["attributes"]["NORMAL"]);
        const auto indices = file.getIndices(primitive["indices"]);
        ASSERT_EQ(vertices.size(), normals.size());
        for (std::size_t corner = 0; corner < indices.size(); corner += 3)
        {
            const osg::Vec3 first = vertices.at(indices[corner]);
            osg::Vec3 plane = (vertices.at(indices[corner + 1]) - first) ^ (vertices.at(indices[corner + 2]) - first);
            plane.normalize();
            EXPECT_GT(plane * normals.at(indices[corner]), 0.9f); // those of studs are rounded
            EXPECT_NEAR(normals.at(indices[corner]).length(), 1.0f, 1e-6f);
        }
    }
}

TEST_F(GltfWriter, DividesLargeModelsIntoBlocks)
{
    std::vector<Part> parts;
    for (const int x : {0, 50, 70, 200})
        parts.push_back({{static_cast<std::uint16_t>(x), 0, 0}, {2, 4, 1}, {200, 30, 0}, Part::NO_CODE});
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(createPartGrid({202, 4, 1}, 1.2), parts);
    const InstancedGltf file = write(*createStoredNode(*model, "parts=bricks"));
    EXPECT_EQ(sortedBoxes(file), expectedBoxes(*model));
    std::map<std::int64_t, int> counts;
    for (const InstancedGltf::Box& box : file.getBoxes())
        ++counts[box.node];
    ASSERT_EQ(counts.size(), 3u); // of 64 cells: from 0, from 64, and from 192 on
    EXPECT_EQ(counts.begin()->second, 2);
    EXPECT_EQ(file.getAll("meshes").size(), 1u);
}

TEST_F(GltfWriter, StoresManyColoursByInstance)
{
    std::vector<Brick> bricks;
    for (int number = 0; number < 1025; ++number)
        bricks.push_back({{static_cast<std::uint16_t>(number % 41), static_cast<std::uint16_t>(number / 41), 0},
                          {static_cast<std::uint8_t>(number % 256), static_cast<std::uint8_t>(number / 256), 77},
                          0});
    const osg::ref_ptr<const BrickModel> model = BrickModel::create(createPartGrid({41, 25, 1}), bricks);
    const osg::ref_ptr<LegoNode> lego = createStoredNode(*model, "16");
    const std::string notices = noticesOf(
        [&]
        {
            const InstancedGltf file = write(*lego);
            EXPECT_EQ(file.getAll("materials").size(), 1u);
            EXPECT_EQ(sortedBoxes(file), expectedBoxes(*model));
        });
    EXPECT_NE(notices.find("its 1,025 colours are attributes of instances"), std::string::npos) << notices;
    bricks.pop_back();
    const osg::ref_ptr<const BrickModel> fewer = BrickModel::create(createPartGrid({41, 25, 1}), bricks);
    EXPECT_EQ(noticesOf([&] { EXPECT_EQ(write(*createStoredNode(*fewer, "16")).getAll("materials").size(), 1024u); }),
              "");
}

TEST_F(GltfWriter, NamesMeshesAndMaterials)
{
    const std::vector<Part> parts{{{0, 0, 0}, {2, 4, 1}, {1, 2, 3}, Part::NO_CODE}};
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(createPartGrid({2, 4, 1}, 1.2), parts);
    const InstancedGltf file = write(*createStoredNode(*model, "parts=bricks"));
    EXPECT_EQ(file.getAll("meshes").at(0)["name"].toText(), "Brick 2 x 4, #010203");
    const JsonValue& surface = file.getAll("materials").at(0)["pbrMetallicRoughness"];
    EXPECT_EQ(surface["metallicFactor"].toNumber(), 0.0);
    EXPECT_EQ(surface["roughnessFactor"].toNumber(), 0.3);
}

TEST_F(GltfWriter, WritesStreams)
{
    const osg::ref_ptr<LegoNode> lego = createStoredNode(*createColoredParts({5, 4, 3}), "parts=bricks");
    std::ostringstream stream;
    ASSERT_TRUE(
        osgDB::Registry::instance()->getReaderWriterForExtension("glb")->writeNode(*lego, stream, nullptr).success());
    write(*lego);
    EXPECT_EQ(stream.str(), contentsOf(pathOf("bricks.glb")));
}

TEST_F(GltfWriter, LeavesOutHiddenNodes)
{
    const osg::ref_ptr<osg::Switch> scene = new osg::Switch;
    const osg::ref_ptr<const BrickModel> shown = createColoredParts({5, 4, 3});
    scene->addChild(createStoredNode(*createColoredParts({3, 3, 3}), "parts=bricks"), false);
    scene->addChild(createStoredNode(*shown, "parts=bricks"), true);
    EXPECT_EQ(sortedBoxes(write(*scene)), expectedBoxes(*shown));
}

TEST_F(GltfWriter, WritesNoFileWithoutBricks)
{
    EXPECT_NE(errorOf(*createSphere(6)).find("there are no bricks in it; expected a LegoNode"), std::string::npos);
    const osg::ref_ptr<LegoNode> empty = new LegoNode;
    EXPECT_NE(errorOf(*empty).find("the model has no bricks"), std::string::npos);
    EXPECT_EQ(countFiles(), 0u);
}

TEST_F(GltfWriter, KeepsTheOldFileIfTransformsCantBeRepresented)
{
    const osg::ref_ptr<LegoNode> lego = createStoredNode(*createColoredParts({5, 4, 3}), "parts=bricks");
    write(*lego);
    const std::string old = contentsOf(pathOf("bricks.glb"));
    const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform;
    transform->addChild(lego);
    transform->setMatrix(osg::Matrixd::rotate(0.5, 0, 0, 1) * osg::Matrixd::scale(1, 2, 1));
    EXPECT_NE(errorOf(*transform).find("is below a transform that shears it"), std::string::npos);
    transform->setMatrix(osg::Matrixd::scale(1, 0, 1));
    EXPECT_NE(errorOf(*transform).find("is below a transform without an inverse"), std::string::npos);
    transform->setMatrix(osg::Matrixd::perspective(60, 1, 1, 10));
    EXPECT_NE(errorOf(*transform).find("expected one without perspective"), std::string::npos);
    transform->setMatrix(osg::Matrixd::scale(std::numeric_limits<double>::infinity(), 1, 1));
    EXPECT_NE(errorOf(*transform).find("is below a transform that is infinite"), std::string::npos);
    EXPECT_EQ(contentsOf(pathOf("bricks.glb")), old);
    EXPECT_EQ(countFiles(), 1u);
}

} // namespace

} // namespace osgLego::test
