#include <osgLego/CpuLegolizer.h>
#include <osgLego/data/BrickPoints.h>

#include <GlTest.h>
#include <Meshes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <EGL/egl.h>
#include <osg/GLExtensions>
#include <osg/Geometry>
#include <osg/Group>

namespace osgLego::test
{

namespace
{

constexpr GLenum VERTEX_ATTRIBUTE_BUFFER = 0x889F; // GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING

using GetVertexAttribute = void(GL_APIENTRY*)(GLuint, GLenum, GLint*);

using Cells = std::vector<glm::ivec3>;

/** A triangle inside each cell, and inside the first and last cell of a grid, to fix the grid's size. */
osg::ref_ptr<osg::Node> createInCells(const glm::ivec3& size, const Cells& cells)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    const auto add = [&](const osg::Vec3& origin, float reach)
    {
        vertices->push_back(origin);
        vertices->push_back(origin + osg::Vec3(reach, 0, 0.5f * reach));
        vertices->push_back(origin + osg::Vec3(0, reach, reach));
        const auto number = static_cast<float>(colors->size() / 3 % 16);
        colors->insert(colors->end(), 3, osg::Vec4(number / 15.0f, 1.0f - number / 15.0f, 0.5f, 1.0f));
    };
    add(osg::Vec3(), 0.3f);
    const osg::Vec3 far(static_cast<float>(size.x), static_cast<float>(size.y), static_cast<float>(size.z));
    add(far, -0.3f);
    for (const glm::ivec3& cell : cells)
    {
        const osg::Vec3 lowest(static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z));
        add(lowest + osg::Vec3(0.3f, 0.3f, 0.3f), 0.4f);
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

Cells createRandomCells(const glm::ivec3& size, double share)
{
    std::mt19937 random(11);
    std::bernoulli_distribution isCovered(share);
    Cells cells;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (isCovered(random)) cells.emplace_back(x, y, z);
    return cells;
}

/** Pairs of neighbours along each axis, half of them on either side of boundaries between blocks of 8 cells or words of
 * 4 or 2 cells. */
Cells createPairs(const glm::ivec3& size)
{
    Cells cells;
    for (int axis = 0; axis < 3; ++axis)
        for (int place = 1; place + 1 < size[axis]; ++place)
        {
            glm::ivec3 cell(1 + 3 * axis);
            cell[axis] = place;
            cell[(axis + 1) % 3] += 5 * (place % 3);
            cells.push_back(cell);
            ++cell[axis];
            cells.push_back(cell);
        }
    return cells;
}

struct Case
{
    const char* name;
    const char* settings;
    std::function<osg::ref_ptr<osg::Node>()> create;
};

/** The contents of the buffer that bricks are drawn from. */
class BrickExtraction : public GlTest, public ::testing::WithParamInterface<Case>
{
protected:
    /** The bricks last drawn in the current context, in the order of their buffer. */
    static std::vector<Brick> readDrawn(osg::GraphicsContext& context, std::size_t count)
    {
        const auto getAttribute = reinterpret_cast<GetVertexAttribute>(eglGetProcAddress("glGetVertexAttribiv"));
        GLint buffer = 0;
        getAttribute(0, VERTEX_ATTRIBUTE_BUFFER, &buffer);
        std::vector<std::array<std::uint32_t, 3>> points(count);
        const osg::GLExtensions& extensions = *context.getState()->get<osg::GLExtensions>();
        extensions.glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
        extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(points[0])),
                                      points.data());
        extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
        std::vector<Brick> bricks;
        for (const auto& [columns, layer, color] : points)
        {
            const auto part = [](std::uint32_t word, int shift) { return static_cast<std::uint8_t>(word >> shift); };
            Brick brick;
            brick.cell = {static_cast<std::uint16_t>(columns), static_cast<std::uint16_t>(columns >> 16),
                          static_cast<std::uint16_t>(layer)};
            brick.openSides = part(layer, 16);
            brick.color = {part(color, 0), part(color, 8), part(color, 16)};
            EXPECT_EQ(layer >> 22, 0u) << "joined sides or lengths of a part";
            EXPECT_EQ(color >> 24, NO_PART);
            bricks.push_back(brick);
        }
        return bricks;
    }

    static std::vector<Brick> getVisible(const BrickModel& model)
    {
        std::vector<Brick> bricks = model.getBricks();
        std::erase_if(bricks, [](const Brick& brick) { return brick.openSides == 0; });
        return bricks;
    }

    static bool isBefore(const Brick& a, const Brick& b)
    {
        return std::lexicographical_compare(a.cell.rbegin(), a.cell.rend(), b.cell.rbegin(), b.cell.rend());
    }

    static std::array<int, 3> blockOf(const Brick& brick)
    {
        return {brick.cell[0] / 8, brick.cell[1] / 8, brick.cell[2] / 8};
    }
};

TEST_P(BrickExtraction, DrawsEveryVisibleBrickOnceBlockByBlock)
{
    const LegoSettings settings = parseSettings(GetParam().settings);
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->setReadBack(true);
    lego->addChild(GetParam().create());
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    viewer.frame();
    const unsigned int contextID = context->getState()->getContextID();
    ASSERT_TRUE(lego->isLegolized(contextID)) << lego->getFailure(contextID);

    const std::vector<Brick> expected = getVisible(*lego->getBricks(contextID));
    ASSERT_FALSE(expected.empty());
    ASSERT_EQ(lego->getStatistics(contextID).numDrawnBricks, expected.size());
    ASSERT_TRUE(context->makeCurrent());
    std::vector<Brick> found = readDrawn(*context, expected.size());
    context->releaseContext();

    std::vector<std::array<int, 3>> blocks;
    for (const Brick& brick : found)
        if (blocks.empty() || blocks.back() != blockOf(brick)) blocks.push_back(blockOf(brick));
    std::sort(blocks.begin(), blocks.end());
    const auto numRepeated = std::distance(std::unique(blocks.begin(), blocks.end()), blocks.end());
    // A layer of blocks that two slabs share appears twice; there are at most three slabs.
    const glm::ivec3& dimensions = lego->getBricks(contextID)->getGrid().dimensions;
    const bool hasSlabs = lego->getBricks(contextID)->getGrid().getNumCells() > std::size_t(1) << 24;
    EXPECT_LE(numRepeated, hasSlabs ? 2 * ((dimensions.x + 7) / 8) * ((dimensions.y + 7) / 8) : 0);

    std::sort(found.begin(), found.end(), isBefore);
    for (std::size_t brick = 0; brick < found.size(); ++brick)
    {
        ASSERT_EQ(found[brick].cell, expected[brick].cell) << brick;
        ASSERT_EQ(found[brick].openSides, expected[brick].openSides) << brick;
        for (std::size_t channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(found[brick].color[channel], expected[brick].color[channel], 1) << brick;
    }
    const bool isExact = settings.voxelization.method == VoxelizationMethod::EXACT;
    EXPECT_TRUE(!isExact || expected.size() == getVisible(*lego->getBricks()).size());
}

/** Random cells: the given share of a grid's cells. */
std::function<osg::ref_ptr<osg::Node>()> random(const glm::ivec3& size, double share)
{
    return [=] { return createInCells(size, createRandomCells(size, share)); };
}

std::function<osg::ref_ptr<osg::Node>()> pairs(const glm::ivec3& size)
{
    return [=] { return createInCells(size, createPairs(size)); };
}

INSTANTIATE_TEST_SUITE_P(
    Grids, BrickExtraction,
    ::testing::Values(
        Case{"OneCell", "1", random({1, 1, 1}, 1)}, Case{"Row", "9", random({9, 1, 1}, 1)},
        Case{"Column", "19", random({1, 1, 19}, 0.5)}, Case{"NoMultiples", "21", random({13, 9, 21}, 0.3)},
        Case{"NoMultiplesFull", "21", random({13, 21, 18}, 1)}, Case{"Multiples", "24", random({24, 16, 8}, 0.7)},
        Case{"EmptyBlocksBetween", "100", random({100, 3, 50}, 0)},
        Case{"FewInMany", "90", random({70, 90, 50}, 0.0003)}, Case{"Neighbours", "29", pairs({29, 26, 23})},
        Case{"BufferThatGrows", "33", random({33, 31, 30}, 0.4)},
        Case{"PointsAddressed", "21,method=points,target=addressed", random({13, 9, 21}, 0.3)},
        Case{"PointsProjected", "29,method=points,target=projected", pairs({29, 26, 23})},
        Case{"PointsOfASphere", "50,method=points,target=addressed", [] { return createSphere(); }},
        Case{"ProjectedSphere", "50,method=points,target=projected", [] { return createSphere(); }},
        Case{"Sphere", "61,proportions=plate,up=y", [] { return createSphere(); }},
        Case{"Palette", "50,palette=ldraw", [] { return createSphere(); }},
        Case{"DitheredPalette", "50,palette=ldraw,colors=8,dither=on", [] { return createSphere(); }},
        Case{"PaletteOfPoints", "50,palette=ldraw,dither=on,method=points", [] { return createSphere(); }},
        Case{"PaletteInSlabs", "270,palette=ldraw,dither=on", [] { return createSphere(); }},
        Case{"Slabs", "1024", pairs({1024, 1000, 30})}, Case{"SlabsOfASphere", "270", [] { return createSphere(); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

} // namespace

} // namespace osgLego::test
