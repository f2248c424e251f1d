#include <osgLego/CpuLegolizer.h>
#include <osgLego/Palette.h>
#include <osgLego/PartType.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/model/CpuBricks.h>
#include <osgLego/model/ModelBuilder.h>

#include <common/RacingCar.h>

#include <Meshes.h>
#include <Notices.h>
#include <Palettes.h>
#include <Settings.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <osg/Geometry>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<const BrickModel> legolize(osg::Node& source, const std::string& settings,
                                        LegoStatistics* statistics = nullptr)
{
    return legolizeOnCpu(source, parseSettings(settings), statistics);
}

std::set<std::array<std::uint8_t, 3>> colorsOf(const BrickModel& model)
{
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const Brick& brick : model.getBricks())
        colors.insert(brick.color);
    return colors;
}

TEST(ModelBuilder, EveryCellOfTheCarBelongsToARealPartInAColorInWhichItWasMade)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read("ldraw", error);
    ASSERT_TRUE(palette) << error;
    for (const char* settings : {"32,parts=bricks", "32,proportions=plate,parts=bricks", "32,up=y,parts=bricks",
                                 "32,parts=bricks,fill=solid", "24,parts=bricks,fill=shell,colors=5,dither=on"})
    {
        const osg::ref_ptr<const BrickModel> model = legolize(*car, settings);
        ASSERT_TRUE(model) << settings;
        std::size_t covered = 0;
        for (const Part& part : model->getParts())
        {
            const PartType* type = findPartType(part, model->getGrid());
            ASSERT_TRUE(type) << settings;
            const auto color = std::find_if(palette->getColors().begin(), palette->getColors().end(),
                                            [&](const PaletteColor& known) { return known.code == part.colorCode; });
            ASSERT_NE(color, palette->getColors().end()) << settings << ": " << part.colorCode;
            EXPECT_EQ(color->color, part.color);
            const std::uint16_t sizes = type->family == PartFamily::BRICK ? color->bricks : color->plates;
            EXPECT_TRUE(sizes >> type->getSizeIndex() & 1) << settings << ": " << type->getName() << color->name;
            covered += static_cast<std::size_t>(part.size[0] * part.size[1] * part.size[2]);
        }
        EXPECT_EQ(covered, model->getBricks().size()) << settings;
        EXPECT_LT(2 * model->getParts().size(), covered) << settings;
    }
}

TEST(ModelBuilder, ThreeStackedPlatesBecomeABrickWhereTheyMay)
{
    const osg::ref_ptr<const BrickModel> model =
        legolize(*createSphere(), "24,proportions=plate,parts=bricks,fill=solid");
    ASSERT_TRUE(model);
    const auto countOf = [&](PartFamily family)
    {
        return std::count_if(model->getParts().begin(), model->getParts().end(),
                             [&](const Part& part) { return findPartType(part, model->getGrid())->family == family; });
    };
    EXPECT_GT(countOf(PartFamily::BRICK), 0);
    EXPECT_GT(countOf(PartFamily::PLATE), 0);
}

TEST(ModelBuilder, TheCellsOfTheSurfaceKeepTheirColors)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    const osg::ref_ptr<const BrickModel> cells = legolize(*car, "32,proportions=brick,palette=ldraw");
    for (const char* settings : {"32,parts=bricks", "32,parts=bricks,fill=solid"})
    {
        const osg::ref_ptr<const BrickModel> model = legolize(*car, settings);
        for (const Brick& cell : cells->getBricks())
        {
            const Brick* brick = model->find(cell.getCell());
            ASSERT_TRUE(brick) << settings;
            EXPECT_EQ(brick->color, cell.color) << settings;
        }
    }
}

TEST(ModelBuilder, EqualSeedsGiveEqualPartsAndOthersGiveOthers)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere();
    const auto partsOf = [&](const char* settings) { return legolize(*sphere, settings)->getParts(); };
    EXPECT_EQ(partsOf("24,parts=bricks,palette=none,seed=3"), partsOf("24,parts=bricks,palette=none,seed=3"));
    EXPECT_NE(partsOf("24,parts=bricks,colors=1,seed=3"), partsOf("24,parts=bricks,colors=1,seed=4"));
}

TEST(ModelBuilder, TheStatisticsDescribeTheModel)
{
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> model =
        legolize(*createRacingCar(), "32,parts=bricks,fill=solid", &statistics);
    ASSERT_TRUE(statistics.layout);
    EXPECT_EQ(statistics.layout->numParts, model->getParts().size());
    EXPECT_EQ(statistics.layout->numCells, model->getBricks().size());
    EXPECT_GT(statistics.layout->numInterior, 0u);
    EXPECT_EQ(statistics.layout->numUnavailable, 0u);
    EXPECT_GE(statistics.layout->numComponents, statistics.layout->numComponentsPossible);
    EXPECT_EQ(statistics.layout->numColors, colorsOf(*model).size());
    EXPECT_GT(statistics.layout->meanColorError, 0.0);
    EXPECT_GE(statistics.layout->maximumColorError, statistics.layout->meanColorError);
}

TEST(ModelBuilder, ALimitedPaletteGivesNoMoreColors)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    EXPECT_EQ(colorsOf(*legolize(*car, "32,palette=ldraw,colors=1")).size(), 1u);
    EXPECT_LE(colorsOf(*legolize(*car, "32,palette=ldraw,colors=6,dither=on")).size(), 6u);
    EXPECT_GT(colorsOf(*legolize(*car, "32")).size(), 100u);
}

TEST(ModelBuilder, AProgramMayEndALayout)
{
    double last = -1.0;
    const osg::ref_ptr<const BrickModel> model =
        legolizeOnCpu(*createSphere(), parseSettings("48,parts=bricks,fill=solid"), nullptr,
                      [&](double fraction)
                      {
                          EXPECT_GE(fraction, last);
                          last = fraction;
                          return false;
                      });
    EXPECT_FALSE(model);
    EXPECT_GE(last, 0.0);
    EXPECT_LT(last, 1.0);
}

TEST(ModelBuilder, AnOpenSurfaceHasNoInteriorWhichAWarningSays)
{
    osg::ref_ptr<osg::Node> triangle = createTriangle({0, 0, 0}, {3, 0, 0}, {0, 3, 3});
    osg::ref_ptr<const BrickModel> model;
    const std::string notices = noticesOf([&] { model = legolize(*triangle, "16,fill=solid"); });
    EXPECT_NE(notices.find("the model has no interior, so fill=solid adds no cells"), std::string::npos) << notices;
    EXPECT_EQ(model->getBricks().size(), legolize(*triangle, "16")->getBricks().size());
}

TEST(ModelBuilder, AModelTooLargeToBeFilledIsRefusedWithItsSize)
{
    osg::ref_ptr<osg::Node> sphere = createSphere(6);
    osg::ref_ptr<const BrickModel> model;
    const std::string notices = noticesOf([&] { model = legolize(*sphere, "600,fill=solid"); });
    EXPECT_FALSE(model);
    EXPECT_NE(notices.find("cells; expected at most 67108864"), std::string::npos) << notices;
}

TEST(ModelBuilder, OneCellIsOnePart)
{
    const osg::ref_ptr<const BrickModel> model =
        legolize(*createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), "1,parts=bricks,fill=solid");
    ASSERT_TRUE(model);
    ASSERT_EQ(model->getParts().size(), 1u);
    EXPECT_EQ(findPartType(model->getParts()[0], model->getGrid())->number, "3005");
}

/** A palette of one colour in which bricks of some sizes were made; bit 0 is 1x1. */
osg::ref_ptr<const Palette> createRed(std::uint16_t bricks)
{
    PaletteColor red;
    red.color = {200, 0, 0};
    red.bricks = bricks;
    return createPalette({red});
}

TEST(ModelBuilder, PartsAreKeptOnlyIfThePaletteAndTheSettingsAreTheSame)
{
    const osg::ref_ptr<const BrickModel> cells = legolize(*createSphere(), "12,proportions=brick");
    const LegoSettings settings = parseSettings("12,parts=bricks");
    const osg::ref_ptr<const Palette> palette = createRed(PaletteColor::ALL_SIZES);
    const auto numPartsAfter = [&](const LegoSettings& before, const osg::ref_ptr<const Palette>& paletteBefore)
    {
        PreviousLayout previous{
            before, {}, {paletteBefore->getColors().begin(), paletteBefore->getColors().end()}, {}, {}};
        for (const Brick& cell : cells->getBricks())
            previous.parts.push_back({{cell.cell[0], cell.cell[1], cell.cell[2]}});
        ModelBuilder builder(settings, PaletteLookup(palette));
        builder.setPrevious(previous);
        const osg::ref_ptr<const BrickModel> model = builder.build(*cells);
        EXPECT_EQ(previous.parts.size(), model->getParts().size());
        EXPECT_EQ(previous.settings, settings);
        EXPECT_EQ(previous.colors.front(), palette->getColors().front());
        return model->getParts().size();
    };
    const std::size_t numCells = cells->getBricks().size();
    EXPECT_EQ(numPartsAfter(settings, palette), numCells);
    EXPECT_EQ(numPartsAfter(parseSettings("12,parts=bricks,show=load"), palette), numCells) << "a setting of the view";
    EXPECT_LT(numPartsAfter(settings, createRed(1)), numCells / 2) << "only bricks 1x1 were made before";
    EXPECT_LT(numPartsAfter(parseSettings("12,parts=bricks,seed=1"), palette), numCells / 2);
}

/** The place of a part in the lattice, its size and its colour. */
using LatticePart = std::array<int, 9>;

/** The parts that lie within `distance` cells of the lattice's origin, along every axis. */
std::vector<LatticePart> findNearParts(const BrickModel& model, int distance)
{
    const BrickGrid& grid = model.getGrid();
    std::vector<LatticePart> near;
    for (const Part& part : model.getParts())
    {
        LatticePart found{};
        bool isNear = true;
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto index = static_cast<std::size_t>(axis);
            const int first = static_cast<int>(std::lround(grid.origin[axis] / grid.cellSize[axis])) + part.cell[index];
            found[index] = first;
            found[index + 3] = part.size[index];
            found[index + 6] = part.color[index];
            isNear = isNear && first >= -distance && first + part.size[index] <= distance;
        }
        if (isNear) near.push_back(found);
    }
    std::sort(near.begin(), near.end());
    return near;
}

TEST(ModelBuilder, DistantPartsStayWhenTheExtentOfTheSourceChanges)
{
    for (const std::string text : {"cell=0.15,parts=bricks,effort=instant,fill=solid",
                                   "cell=0.15,parts=bricks,effort=instant,up=y,proportions=plate"})
        for (const osg::Vec3d direction : {osg::Vec3d(-1, 0, 0), osg::Vec3d(0, -1, 0), osg::Vec3d(0, 0, -1)})
        {
            const LegoSettings settings = parseSettings(text);
            osg::ref_ptr<osg::MatrixTransform> mover = new osg::MatrixTransform;
            mover->addChild(createSphere());
            osg::ref_ptr<osg::Group> source = new osg::Group;
            source->addChild(createSphere());
            source->addChild(mover);
            PreviousLayout previous;
            std::vector<LatticePart> before;
            for (const double distance : {4.0, 4.1, 5.5, 4.8})
            {
                mover->setMatrix(osg::Matrixd::translate(direction * distance));
                std::string error;
                const osg::ref_ptr<const LegoSource> lego =
                    LegoSource::create(*SceneTriangles::create(*source), settings, error);
                ASSERT_TRUE(lego) << error;
                CpuBricksWork work;
                work.previous = &previous;
                const std::vector<LatticePart> near = findNearParts(*makeBricksOnCpu(*lego, work), 7);
                EXPECT_GT(near.size(), 50u);
                if (distance == 4.0) before = near;
                EXPECT_EQ(near, before) << text << " at " << distance;
            }
        }
}

void addRectangle(osg::Group& group, double left, double right, const osg::Vec4& color)
{
    const osg::ref_ptr<osg::Geometry> rectangle = osg::createTexturedQuadGeometry(
        osg::Vec3(static_cast<float>(left), 0.0f, 0.5f), {static_cast<float>(right - left), 0, 0}, {0, 8, 0});
    const osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1);
    (*colors)[0] = color;
    rectangle->setColorArray(colors, osg::Array::BIND_OVERALL);
    group.addChild(rectangle);
}

/** The colours of the cells of a lattice of unit cells, by their places along x and y. */
std::map<std::pair<long, long>, std::array<std::uint8_t, 3>> findLatticeColors(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    std::map<std::pair<long, long>, std::array<std::uint8_t, 3>> colors;
    for (const Brick& brick : model.getBricks())
        colors[{std::lround(grid.origin.x) + brick.cell[0], std::lround(grid.origin.y) + brick.cell[1]}] = brick.color;
    return colors;
}

TEST(ModelBuilder, CellsThatTwoSurfacesShareDoNotFlicker)
{
    constexpr int NUM_CELLS = 16;
    for (const char* text : {"cell=1,palette=ldraw", "cell=1,parts=bricks,effort=instant"})
    {
        const LegoSettings settings = parseSettings(text);
        PreviousLayout previous;
        std::map<std::pair<long, long>, std::array<std::uint8_t, 3>> before;
        // The border between red and white moves within each cell, and the grid begins elsewhere.
        for (const double red : {0.42, 0.56, 0.44, 0.58})
        {
            const osg::ref_ptr<osg::Group> group = new osg::Group;
            for (int cell = 0; cell < NUM_CELLS; ++cell)
            {
                addRectangle(*group, cell, cell + red, {0.7f, 0.0f, 0.0f, 1.0f});
                addRectangle(*group, cell + red, cell + 1.0, {1.0f, 1.0f, 1.0f, 1.0f});
            }
            addRectangle(*group, red < 0.5 ? -2.5 : -4.5, -0.1, {0.0f, 0.0f, 0.7f, 1.0f});
            std::string error;
            const osg::ref_ptr<const LegoSource> source =
                LegoSource::create(*SceneTriangles::create(*group), settings, error);
            ASSERT_TRUE(source) << error;
            CpuBricksWork work;
            work.previous = &previous;
            const osg::ref_ptr<const BrickModel> model = makeBricksOnCpu(*source, work);
            ASSERT_TRUE(model) << work.error;
            const auto colors = findLatticeColors(*model);
            std::size_t numCompared = 0;
            for (const auto& [place, color] : before)
            {
                if (place.first < 0) continue;
                ++numCompared;
                EXPECT_EQ(colors.at(place), color) << text << " with " << red << " in " << place.first;
            }
            EXPECT_GE(numCompared, before.empty() ? 0u : std::size_t(NUM_CELLS * 8));
            before = colors;
        }
    }
}

TEST(ModelBuilder, ErrorsOfColorsAreThoseOfVisibleCells)
{
    // A cube of 27 cells, of which the one in the middle is blue. The palette has the colour of the others.
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, 1.2};
    grid.dimensions = glm::ivec3(3);
    std::vector<Brick> bricks;
    for (std::uint16_t z = 0; z < 3; ++z)
        for (std::uint16_t y = 0; y < 3; ++y)
            for (std::uint16_t x = 0; x < 3; ++x)
            {
                Brick& brick = bricks.emplace_back();
                brick.cell = {x, y, z};
                brick.color = {200, 0, 0};
                if (x == 1 && y == 1 && z == 1) brick.color = {0, 0, 200};
            }
    ModelBuilder builder(parseSettings("3,parts=bricks"), PaletteLookup(createRed(PaletteColor::ALL_SIZES)));
    ASSERT_TRUE(builder.build(*BrickModel::create(grid, std::move(bricks))));
    EXPECT_EQ(builder.getMeasurement()().meanColorError, 0.0);
    EXPECT_EQ(builder.getMeasurement()().maximumColorError, 0.0);
}

} // namespace

} // namespace osgLego::test
