#include <osgLego/cpu/CpuVoxelizer.h>

#include <Meshes.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Texture2D>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

constexpr Color RED{200, 0, 0};
constexpr Color WHITE{255, 255, 255};

/** Triangles that add rectangles of one cell's height and any width, in any number of pieces. */
class Wall
{
public:
    void add(double from, double to, const Color& color, int numPieces = 1)
    {
        const double width = (to - from) / numPieces;
        for (int piece = 0; piece < numPieces; ++piece)
            addPiece(static_cast<float>(from + piece * width), static_cast<float>(from + (piece + 1) * width), color);
    }

    /** The colours of its cells, from left to right. */
    std::vector<Color> voxelize(CellColor rule, unsigned int numCells = 1) const
    {
        const osg::ref_ptr<const BrickModel> model = createModel(rule, numCells);
        std::vector<Color> colors;
        for (const Brick& brick : model->getBricks())
            colors.push_back(brick.color);
        return colors;
    }

    osg::ref_ptr<const BrickModel> createModel(CellColor rule, unsigned int numCells = 1,
                                               const PreviousCells* previous = nullptr) const
    {
        LegoSettings settings;
        settings.grid.resolution = numCells;
        const osg::ref_ptr<const GridTriangles> triangles =
            GridTriangles::create(*SceneTriangles::create(*_geode), settings);
        return voxelizeOnCpu(*triangles, rule, previous);
    }

private:
    void addPiece(float from, float to, const Color& color)
    {
        for (const bool isUpper : {false, true})
        {
            const osg::Vec3 third = isUpper ? osg::Vec3(from, 0, 1) : osg::Vec3(to, 0, 0);
            const osg::ref_ptr<osg::Geometry> triangle = test::createTriangle({from, 0, 0}, third, {to, 0, 1});
            const osg::ref_ptr<osg::Vec4ubArray> colors = new osg::Vec4ubArray(1);
            (*colors)[0] = osg::Vec4ub(color[0], color[1], color[2], 255);
            colors->setNormalize(true);
            triangle->setColorArray(colors, osg::Array::BIND_OVERALL);
            _geode->addDrawable(triangle);
        }
    }

    osg::ref_ptr<osg::Geode> _geode = new osg::Geode;
};

TEST(DominantColors, TheColourOfTheLargerAreaWins)
{
    for (const double border : {0.1, 0.3, 0.48, 0.52, 0.7, 0.9})
    {
        Wall wall;
        wall.add(0.0, border, RED);
        wall.add(border, 1.0, WHITE);
        EXPECT_EQ(wall.voxelize(CellColor::DOMINANT), std::vector{border > 0.5 ? RED : WHITE}) << border;
    }
}

TEST(DominantColors, ACellKeepsItsColourUntilAnotherOneHasSixTenthsOfTheArea)
{
    const auto createWall = [](double share)
    {
        Wall wall;
        wall.add(0.0, share, RED, 3);
        wall.add(share, 1.0, WHITE);
        return wall;
    };
    osg::ref_ptr<const BrickModel> model = createWall(0.3).createModel(CellColor::DOMINANT);
    const auto moveTo = [&](double share)
    {
        const PreviousCells previous(*model);
        model = createWall(share).createModel(CellColor::DOMINANT, 1, &previous);
        return model->getBricks().front().color;
    };
    for (const double share : {0.45, 0.55, 0.45, 0.58})
        EXPECT_EQ(moveTo(share), WHITE) << share;
    for (const double share : {0.62, 0.55, 0.45, 0.55, 0.42})
        EXPECT_EQ(moveTo(share), RED) << share;
    EXPECT_EQ(moveTo(0.38), WHITE);
}

TEST(DominantColors, ACellPrefersTheColourThatItHadInTheLattice)
{
    // Cells of two colours in nearly equal areas. Those of the earlier wall begin three cells further left.
    constexpr int NUM_CELLS = 12;
    constexpr int STEP = 3;
    Wall before;
    Wall after;
    for (int cell = 0; cell < NUM_CELLS; ++cell)
    {
        const bool wasRed = cell % 2 == 0;
        before.add(cell, cell + 0.7, wasRed ? RED : WHITE);
        before.add(cell + 0.7, cell + 1.0, wasRed ? WHITE : RED);
        after.add(cell, cell + 0.5, RED);
        after.add(cell + 0.5, cell + 1.0, WHITE);
    }
    const PreviousCells previous(*before.createModel(CellColor::DOMINANT, NUM_CELLS), {STEP, 0, 0});
    const osg::ref_ptr<const BrickModel> model = after.createModel(CellColor::DOMINANT, NUM_CELLS, &previous);
    ASSERT_EQ(model->getBricks().size(), std::size_t(NUM_CELLS));
    for (const Brick& brick : model->getBricks())
    {
        const int place = brick.cell[0] + STEP;                  // in the earlier wall
        const bool isRed = place >= NUM_CELLS || place % 2 == 0; // a new cell has the colour of equal areas
        EXPECT_EQ(brick.color, isRed ? RED : WHITE) << brick.cell[0];
    }
}

TEST(DominantColors, ManySmallPiecesOutweighALargeOne)
{
    Wall wall;
    wall.add(0.0, 0.4, RED);
    wall.add(0.4, 1.0, WHITE, 20);
    EXPECT_EQ(wall.voxelize(CellColor::DOMINANT), std::vector{WHITE});
}

TEST(DominantColors, EqualAreasHaveTheSameColourInEveryCellOfABorder)
{
    for (const bool isRedFirst : {false, true})
    {
        Wall wall;
        for (int cell = 0; cell < 16; ++cell)
        {
            wall.add(cell, cell + 0.5, isRedFirst == (cell % 3 != 0) ? RED : WHITE, 1 + cell % 4);
            wall.add(cell + 0.5, cell + 1.0, isRedFirst == (cell % 3 != 0) ? WHITE : RED, 1 + cell % 5);
        }
        EXPECT_EQ(wall.voxelize(CellColor::DOMINANT, 16), std::vector<Color>(16, RED));
    }
}

TEST(DominantColors, AShadeBetweenOthersStandsForAGradualChange)
{
    Wall wall;
    for (int stripe = 0; stripe < 64; ++stripe)
    {
        const auto shade = static_cast<std::uint8_t>(4 * stripe);
        wall.add(stripe / 16.0, (stripe + 1) / 16.0, {shade, shade, shade});
    }
    const std::vector<Color> colors = wall.voxelize(CellColor::DOMINANT, 4);
    const std::vector<Color> means = wall.voxelize(CellColor::MEAN, 4);
    ASSERT_EQ(colors.size(), 4u);
    for (std::size_t cell = 0; cell < 4; ++cell)
        EXPECT_NEAR(colors[cell][0], means[cell][0], 4) << cell;
}

constexpr Color GREEN{0, 100, 0};

/** @param getColor of a column and a row, from 0 to 1. */
template <typename GetColor>
osg::ref_ptr<osg::Texture2D> createTexture(int numTexels, const GetColor& getColor)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(numTexels, numTexels, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int row = 0; row < numTexels; ++row)
        for (int column = 0; column < numTexels; ++column)
            std::ranges::copy(getColor((column + 0.5) / numTexels, (row + 0.5) / numTexels),
                              image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row)));
    return new osg::Texture2D(image);
}

/** A square of 8 x 8 cells. */
osg::ref_ptr<osg::Geometry> createTexturedSquare(osg::Texture2D* texture)
{
    osg::ref_ptr<osg::Geometry> square = osg::createTexturedQuadGeometry({0, 0, 0}, {8, 0, 0}, {0, 0, 8});
    square->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return square;
}

osg::ref_ptr<const BrickModel> voxelizeTextured(osg::Node& node, CellColor rule, unsigned int resolution)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    return voxelizeOnCpu(*GridTriangles::create(*SceneTriangles::create(node), settings), rule);
}

osg::ref_ptr<const BrickModel> voxelizeEight(osg::Node& node, CellColor rule)
{
    return voxelizeTextured(node, rule, 8);
}

std::size_t countMixed(const BrickModel& model)
{
    return static_cast<std::size_t>(std::count_if(model.getBricks().begin(), model.getBricks().end(),
                                                  [](const Brick& brick)
                                                  { return brick.color != RED && brick.color != WHITE; }));
}

/** Halfway between red and white, as at the smooth borders of painted textures. */
constexpr Color PINK{228, 128, 128};

TEST(DominantColors, ATextureOfTwoColorsIsNotMixed)
{
    std::size_t numMixedMeans = 0;
    for (const int numTexels : {7, 16, 61, 256, 1000})
        for (const double border : {0.31, 0.36, 0.42, 0.45})
            for (const bool isSmooth : {false, true})
            {
                const double red = std::floor(border * numTexels) / numTexels;
                const double end = red + (isSmooth ? 1.0 / numTexels : 0.0);
                if (isSmooth && numTexels < 200) continue; // a wide stripe is no border
                const osg::ref_ptr<osg::Geometry> square =
                    createTexturedSquare(createTexture(numTexels, [&](double column, double)
                                                       { return column < red   ? RED
                                                                : column < end ? PINK
                                                                               : WHITE; })
                                             .get());
                const osg::ref_ptr<const BrickModel> model = voxelizeEight(*square, CellColor::DOMINANT);
                for (const Brick& brick : model->getBricks())
                {
                    // Red has more than half of the cell's width.
                    const double width = 8.0 * red - brick.cell[0];
                    if (std::abs(width - 0.5) > 0.15)
                    {
                        EXPECT_EQ(brick.color == RED, width > 0.5) << numTexels << ' ' << width;
                    }
                }
                EXPECT_EQ(countMixed(*model), 0u) << numTexels << ' ' << border << ' ' << isSmooth;
                numMixedMeans += countMixed(*voxelizeEight(*square, CellColor::MEAN));
            }
    EXPECT_GT(numMixedMeans, 150u);
}

TEST(DominantColors, SpotsOfATextureAreNotMixed)
{
    // White spots of one to two cells on red, on a surface of many triangles that stretches the texture.
    const auto getColor = [](double column, double row)
    {
        const double radius = 0.06 + 0.06 * row;
        const double x = std::remainder(column, 0.25);
        const double y = std::remainder(row, 0.25);
        return x * x + y * y < radius * radius ? WHITE : RED;
    };
    const osg::ref_ptr<osg::Texture2D> texture = createTexture(512, getColor);
    constexpr int NUM = 40;
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (int piece = 0; piece < NUM; ++piece)
    {
        const float left = static_cast<float>(piece) / NUM;
        const osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(
            {8.0f * left, 0, 0}, {8.0f / NUM, 0, 0}, {0, 0, 3}, left, 0.0f, left + 1.0f / NUM, 1.0f);
        quad->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
        geode->addDrawable(quad);
    }
    EXPECT_GT(countMixed(*voxelizeEight(*geode, CellColor::MEAN)), 10u);
    EXPECT_EQ(countMixed(*voxelizeEight(*geode, CellColor::DOMINANT)), 0u);
}

TEST(DominantColors, LinesOfPixelArtKeepTheirWidthAndShades)
{
    // Stripes one texel wide, some of them between their neighbours in colour.
    constexpr Color GREY{120, 120, 120};
    constexpr Color BLACK{20, 20, 20};
    constexpr std::array STRIPES{WHITE, GREY, BLACK, WHITE, RED, WHITE, GREEN, GREY};
    for (const int numCellsPerTexel : {1, 2, 4})
        for (const bool isUpright : {false, true})
        {
            const int numTexels = 8 / numCellsPerTexel;
            const auto colorAt = [&](double place) { return STRIPES[static_cast<std::size_t>(place * numTexels)]; };
            const osg::ref_ptr<osg::Geometry> square = createTexturedSquare(
                createTexture(numTexels, [&](double column, double row) { return colorAt(isUpright ? column : row); })
                    .get());
            const osg::ref_ptr<const BrickModel> model = voxelizeEight(*square, CellColor::DOMINANT);
            EXPECT_EQ(model->getBricks().size(), 64u);
            for (const Brick& brick : model->getBricks())
                EXPECT_EQ(brick.color, colorAt((brick.cell[isUpright ? 0 : 2] + 0.5) / 8.0))
                    << numCellsPerTexel << ' ' << isUpright << ' ' << brick.cell[0] << ' ' << brick.cell[2];
        }
}

TEST(DominantColors, DotsOfPixelArtKeepTheirShape)
{
    // One white texel amid red ones.
    constexpr int NUM_TEXELS = 5;
    const auto colorAt = [](double column, double row)
    {
        const bool isInMiddle = static_cast<int>(NUM_TEXELS * column) == 2 && static_cast<int>(NUM_TEXELS * row) == 2;
        return isInMiddle ? WHITE : RED;
    };
    const osg::ref_ptr<osg::Geometry> square = createTexturedSquare(createTexture(NUM_TEXELS, colorAt).get());
    for (const int numCellsPerTexel : {1, 2, 3, 4, 6, 40})
    {
        const int resolution = NUM_TEXELS * numCellsPerTexel;
        const osg::ref_ptr<const BrickModel> model =
            voxelizeTextured(*square, CellColor::DOMINANT, static_cast<unsigned int>(resolution));
        EXPECT_EQ(model->getBricks().size(), static_cast<std::size_t>(resolution * resolution));
        const auto numWrong = std::count_if(
            model->getBricks().begin(), model->getBricks().end(),
            [&](const Brick& brick)
            { return brick.color != colorAt((brick.cell[0] + 0.5) / resolution, (brick.cell[2] + 0.5) / resolution); });
        EXPECT_EQ(numWrong, 0) << numCellsPerTexel;
    }
}

TEST(DominantColors, NoColorComesFromBesideATrianglesTexels)
{
    // A strip within the first column of cells shows a tenth of a texture, and ends at a border of texels. The nearest
    // points to the cells' centres are on its right edge.
    constexpr int NUM_TEXELS = 100;
    for (int tenth = 0; tenth < 10; ++tenth)
    {
        const auto getColor = [&](double column, double)
        { return static_cast<int>(10.0 * column) == tenth ? RED : GREEN; };
        const osg::ref_ptr<osg::Geometry> strip =
            osg::createTexturedQuadGeometry({0, 0, 0}, {0.3f, 0, 0}, {0, 0, 8}, 0.1f * static_cast<float>(tenth), 0.0f,
                                            0.1f * static_cast<float>(tenth + 1), 1.0f);
        strip->getOrCreateStateSet()->setTextureAttributeAndModes(0, createTexture(NUM_TEXELS, getColor));
        const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(strip);
        geode->addDrawable(test::createTriangle({7.9f, 0, 0}, {8, 0, 0}, {8, 0, 0.1f})); // white; the grid is square
        const osg::ref_ptr<const BrickModel> model = voxelizeEight(*geode, CellColor::DOMINANT);
        EXPECT_EQ(model->getBricks().size(), 9u);
        EXPECT_EQ(std::count_if(model->getBricks().begin(), model->getBricks().end(),
                                [](const Brick& brick) { return brick.color == RED; }),
                  8)
            << tenth;
    }
}

TEST(DominantColors, TheOtherSideOfARepeatedTextureIsNotSeen)
{
    // The tip of a triangle is at the upper edge of the texture, whose lower half the triangle does not show.
    const osg::ref_ptr<osg::Texture2D> texture =
        createTexture(256, [](double, double row) { return row < 0.5 ? GREEN : RED; });
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    const osg::ref_ptr<osg::Geometry> triangle = test::createTriangle({0, 0, 0}, {8, 0, 0}, {4.5f, 0, 6.2f});
    const osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (const osg::Vec2& coordinate : {osg::Vec2(0, 0.55f), osg::Vec2(1, 0.55f), osg::Vec2(0.5f, 1)})
        coordinates->push_back(coordinate);
    triangle->setTexCoordArray(0, coordinates);
    triangle->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    const osg::ref_ptr<const BrickModel> model = voxelizeEight(*triangle, CellColor::DOMINANT);
    EXPECT_EQ(std::count_if(model->getBricks().begin(), model->getBricks().end(),
                            [](const Brick& brick) { return brick.cell[2] == 6; }),
              1);
    EXPECT_EQ(countMixed(*model), 0u);
}

TEST(DominantColors, WithoutThemACellHasTheMean)
{
    Wall wall;
    wall.add(0.0, 0.4, RED);
    wall.add(0.4, 1.0, WHITE);
    EXPECT_EQ(wall.voxelize(CellColor::MEAN), std::vector{(Color{233, 153, 153})});
}

} // namespace

} // namespace osgLego
