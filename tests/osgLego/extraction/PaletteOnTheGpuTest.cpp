#include <common/RacingCar.h>
#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/TriangleColor.h>
#include <osgLego/cpu/TriangleOverlap.h>
#include <osgLego/data/PassConstants.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/palette/PaletteLookup.h>

#include <CellClipping.h>
#include <GlTest.h>
#include <Meshes.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <unistd.h>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <osg/Geode>
#include <osg/Texture2D>

namespace osgLego::test
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

struct Model
{
    const char* name;
    std::function<osg::ref_ptr<osg::Node>()> create;
    /** The percentage of cells in which several texels are nearly as good: GL filters with few bits. */
    double nearlyEqualTexels = 0.0;
};

class PaletteOnTheGpu : public GlTest, public ::testing::WithParamInterface<Model>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _node = GetParam().create();
        if (!_node) GTEST_SKIP() << "the model could not be fetched";
    }

    osg::ref_ptr<const LegoSource> createSource(const LegoSettings& settings) const
    {
        std::string error;
        osg::ref_ptr<const LegoSource> source = LegoSource::create(*SceneTriangles::create(*_node), settings, error);
        EXPECT_TRUE(source) << error;
        return source;
    }

    osg::ref_ptr<osg::Node> _node;
};

/** The part of a triangle in a cell. */
struct Piece
{
    glm::vec3 color{0.0f}; //!< that it contributes to the mean
    glm::vec3 plain{0.0f}; //!< that the cell may have
    double area = 0.0;
};

int numberOf(const glm::ivec3& cell, const glm::ivec3& dimensions)
{
    return cell.x + dimensions.x * (cell.y + dimensions.y * cell.z);
}

/** The pieces in each cell, by brute force: every triangle is clipped by every cell that it overlaps. */
std::unordered_map<int, std::vector<Piece>> findPieces(const GridTriangles& triangles)
{
    std::unordered_map<int, std::vector<Piece>> pieces;
    const glm::ivec3& dimensions = triangles.getGrid().dimensions;
    std::vector<glm::ivec3> cells;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        {
            const GridVertex* corners = &batch.vertices[first];
            const Polygon polygon{corners[0].position, corners[1].position, corners[2].position};
            cells.clear();
            TriangleOverlap(polygon[0], polygon[1], polygon[2]).findCells(dimensions, cells);
            const TriangleColor color(batch, corners);
            for (const glm::ivec3& cell : cells)
            {
                Piece piece;
                const CellPart part{cell, 0.0};
                color.getColors({&part, 1}, &piece.color);
                piece.plain = piece.color;
                if (color.hasMixtures()) color.makePlain({&part, 1}, &piece.plain);
                piece.area = areaOf(clipByCell(polygon, cell)) + PassConstants::LEAST_WEIGHT;
                pieces[numberOf(cell, dimensions)].push_back(piece);
            }
        }
    return pieces;
}

/** The distance of a piece from the mean, with the preference for dark colours. */
double scoreOf(const Piece& piece, const glm::dvec3& mean)
{
    return glm::distance(glm::dvec3(piece.plain), mean) +
           glm::dot(glm::dvec3(piece.plain),
                    glm::dvec3(PassConstants::RED_BIAS, PassConstants::GREEN_BIAS, PassConstants::BLUE_BIAS));
}

/** The palette's colours for a colour that rounding changes by up to a level of 255 per channel. */
void addColors(const PaletteLookup& lookup, const glm::vec3& color, const std::array<std::uint16_t, 3>& cell,
               std::set<Color>& colors)
{
    for (int number = 0; number < 27; ++number)
    {
        const glm::ivec3 offset(number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1);
        const glm::ivec3 rounded = glm::clamp(glm::ivec3(glm::round(255.0f * color)) + offset, 0, 255);
        colors.insert(lookup.getColor({static_cast<std::uint8_t>(rounded.x), static_cast<std::uint8_t>(rounded.y),
                                       static_cast<std::uint8_t>(rounded.z)},
                                      cell));
    }
}

/** The colours that a brick may have if rounding decides between colours that are nearly as good. */
std::set<Color> allowedColors(const std::vector<Piece>& pieces, const PaletteLookup& lookup, const Brick& brick)
{
    // Half floats change the mean by a few levels of 255.
    constexpr double TIE = 0.012;
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const Piece& piece : pieces)
    {
        sum += piece.area * glm::dvec3(piece.color);
        area += piece.area;
    }
    double best = std::numeric_limits<double>::max();
    for (const Piece& piece : pieces)
        best = std::min(best, scoreOf(piece, sum / area));
    std::set<Color> colors;
    for (const Piece& piece : pieces)
        if (scoreOf(piece, sum / area) <= best + TIE) addColors(lookup, piece.plain, brick.cell, colors);
    return colors;
}

/** A palette of one colour, as a file that exists as long as this object. */
class OneColorFile
{
public:
    OneColorFile()
    {
        std::ofstream(_path) << "code,name,rgb,edge,bricklink,bricks,plates\n"
                                "4,Red,#B40000,#333333,5,11111111111,11111111111\n";
    }
    ~OneColorFile() { std::remove(_path.c_str()); }
    OneColorFile(const OneColorFile&) = delete;
    OneColorFile& operator=(const OneColorFile&) = delete;

    const std::string& getPath() const { return _path; }

private:
    std::string _path = ::testing::TempDir() + "one-color-" + std::to_string(::getpid()) + ".csv";
};

TEST_P(PaletteOnTheGpu, GivesTheColoursOfTheCpu)
{
    const OneColorFile oneColor;
    for (const std::string& palette :
         {std::string("ldraw"), std::string("ldraw,colors=6"), std::string("ldraw,dither=on"), oneColor.getPath()})
    {
        const LegoSettings settings = parseSettings("48,proportions=brick,palette=" + palette);
        const osg::ref_ptr<const LegoSource> source = createSource(settings);
        ASSERT_TRUE(source);
        const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*_node, settings);
        ASSERT_TRUE(gpu);
        const osg::ref_ptr<const BrickModel> cpu = voxelizeOnCpu(*source->triangles, CellColor::DOMINANT);
        const auto pieces = findPieces(*source->triangles);
        std::size_t numCommon = 0;
        std::size_t numDifferent = 0;
        std::size_t numWrong = 0;
        for (const Brick& brick : cpu->getBricks())
        {
            const Brick* other = gpu->find(brick.getCell());
            if (!other) continue;
            ++numCommon;
            const Color expected = source->lookup.getColor(brick.color, brick.cell);
            const std::set<Color> allowed =
                allowedColors(pieces.at(numberOf(brick.getCell(), cpu->getGrid().dimensions)), source->lookup, brick);
            EXPECT_EQ(allowed.count(expected), 1u);
            numDifferent += other->color == expected ? 0 : 1;
            numWrong += 1 - allowed.count(other->color);
        }
        const double share = 100.0 * static_cast<double>(numDifferent) / static_cast<double>(numCommon);
        std::printf("%-8s %-60s %6zu cells, %zu (%.2f %%) differ, %zu beyond near ties\n", GetParam().name,
                    settings.toString().c_str(), numCommon, numDifferent, share, numWrong);
        const double ofTexels = GetParam().nearlyEqualTexels;
        EXPECT_LE(100.0 * static_cast<double>(numWrong), ofTexels * static_cast<double>(numCommon));
        EXPECT_GT(numCommon, 500u);
        // Sums of a GPU round otherwise: of the sphere, whose colours change smoothly, 0.2 % differ with an H200.
        EXPECT_LT(share, ofTexels + (isSoftware(*createContext()) ? 0.1 : 0.5));
    }
}

TEST_P(PaletteOnTheGpu, GivesEachPointThePalettesColourForItsOwn)
{
    for (const char* target : {"addressed", "projected"})
        for (const char* palette : {"ldraw", "ldraw,colors=6", "ldraw,dither=on"})
        {
            const std::string points = std::string("40,method=points,target=") + target;
            const LegoSettings settings = parseSettings(points + ",palette=" + palette);
            const osg::ref_ptr<const LegoSource> source = createSource(settings);
            ASSERT_TRUE(source);
            const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*_node, settings);
            const osg::ref_ptr<const BrickModel> own = legolizeOnGpu(*_node, parseSettings(points));
            ASSERT_TRUE(found && own);
            std::vector<Brick> expected = own->getBricks();
            for (Brick& brick : expected)
                brick.color = source->lookup.getColor(brick.color, brick.cell);
            EXPECT_EQ(found->getBricks(), expected) << settings.toString();
        }
}

/** A picture of random texels in five colours. */
osg::ref_ptr<osg::Texture2D> createMosaic(int numTexels)
{
    constexpr std::array<Color, 5> COLORS{{{255, 255, 255}, {200, 0, 0}, {120, 120, 120}, {20, 20, 20}, {0, 100, 0}}};
    std::mt19937 random(1);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(numTexels, numTexels, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int texel = 0; texel < numTexels * numTexels; ++texel)
        std::ranges::copy(COLORS[random() % COLORS.size()], image->data() + 3 * texel);
    return new osg::Texture2D(image);
}

/** Squares with a texture whose texels are wider and narrower than cells, and strips of a part of one, which end at
 * borders of texels before the centres of their cells. */
osg::ref_ptr<osg::Node> createTexturedSquares()
{
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    const auto add = [&](const osg::Vec3& corner, float width, int numTexels, float left, float right)
    {
        const osg::ref_ptr<osg::Geometry> square =
            osg::createTexturedQuadGeometry(corner, {width, 0, 0}, {0, 0, 48}, left, 0.0f, right, 1.0f);
        square->getOrCreateStateSet()->setTextureAttributeAndModes(0, createMosaic(numTexels));
        geode->addDrawable(square);
    };
    int place = 0;
    for (const int numTexels : {12, 48, 130, 333})
        add(osg::Vec3(0.0f, 4.0f * static_cast<float>(place++), 0.0f), 48.0f, numTexels, 0.0f, 1.0f);
    for (int tenth = 0; tenth < 10; ++tenth)
        add(osg::Vec3(4.0f * static_cast<float>(tenth), 20.0f, 0.0f), 0.3f, 100, 0.1f * static_cast<float>(tenth),
            0.1f * static_cast<float>(tenth + 1));
    return geode;
}

INSTANTIATE_TEST_SUITE_P(Models, PaletteOnTheGpu,
                         ::testing::Values(Model{"car", createRacingCar},
                                           Model{"sphere", [] { return createSphere(); }}, Model{"torus", createTorus},
                                           Model{"slivers", [] { return createSliverSoup(); }},
                                           Model{"textures", createTexturedSquares, 0.6}, Model{"bunny", readBunny}),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace

} // namespace osgLego::test
