#include "BrickTowers.h"

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>

namespace osgLego::test
{

namespace
{

constexpr int SIZE = 64; // of the grid, in studs
constexpr int HEIGHT = 128;

/** The model with every part changed. */
osg::ref_ptr<const BrickModel> change(const BrickModel& model, const std::function<void(Part&)>& changePart)
{
    std::vector<Part> parts = model.getParts();
    std::for_each(parts.begin(), parts.end(), changePart);
    return BrickModel::createOfParts(model.getGrid(), std::move(parts));
}

} // namespace

Part createBrick(const glm::ivec3& place, int width, int depth)
{
    Part part;
    for (int axis = 0; axis < 3; ++axis)
        part.cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(place[axis]);
    part.size = {static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(depth), 1};
    return part;
}

osg::ref_ptr<const BrickModel> createPartModel(std::vector<Part> parts, double cellHeight)
{
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, cellHeight};
    grid.dimensions = glm::ivec3(SIZE, SIZE, HEIGHT);
    return BrickModel::createOfParts(grid, std::move(parts));
}

osg::ref_ptr<const BrickModel> createRandomTower(unsigned int seed, int numParts)
{
    std::mt19937 random(seed);
    const auto choose = [&](unsigned int count) { return static_cast<int>(random() % count); };
    constexpr std::array<std::array<int, 2>, 8> SIZES{{{1, 1}, {2, 1}, {1, 4}, {2, 2}, {3, 2}, {2, 4}, {1, 6}, {6, 2}}};
    constexpr int MOST_TRIES = 10000; // for a part, before the pile grows
    int numLayers = 6;
    int numTries = 0;
    std::vector<Part> parts;
    std::set<std::array<int, 3>> covered;
    while (static_cast<int>(parts.size()) < numParts)
    {
        if (++numTries > MOST_TRIES)
        {
            // There may be no room left, but there always is on the top.
            if (++numLayers > HEIGHT) throw std::invalid_argument("a tower can't have as many parts");
            numTries = 0;
        }
        const auto [width, depth] = SIZES[static_cast<std::size_t>(choose(SIZES.size()))];
        const glm::ivec3 place(20 + choose(6), 20 + choose(6), choose(static_cast<unsigned int>(numLayers)));
        bool isFree = true;
        bool isHeld = place.z == 0 && parts.size() < 3;
        for (int y = place.y; y < place.y + depth; ++y)
            for (int x = place.x; x < place.x + width; ++x)
            {
                isFree = isFree && !covered.contains({x, y, place.z});
                isHeld = isHeld || covered.contains({x, y, place.z - 1});
            }
        if (!isFree || !isHeld) continue;
        numTries = 0;
        parts.push_back(createBrick(place, width, depth));
        for (int y = place.y; y < place.y + depth; ++y)
            for (int x = place.x; x < place.x + width; ++x)
                covered.insert({x, y, place.z});
    }
    return createPartModel(std::move(parts));
}

osg::ref_ptr<const BrickModel> createLoadedCantilever(int numBricks1x3, int numBricks1x1)
{
    std::vector<Part> parts{createBrick({0, 1, 0}, 1, 1), createBrick({0, 1, 1}, 8, 1)};
    for (int i = 0; i < numBricks1x3; ++i)
        parts.push_back(createBrick({7, 0, 2 + i}, 1, 3));
    for (int i = 0; i < numBricks1x1; ++i)
        parts.push_back(createBrick({7, 1, 2 + numBricks1x3 + i}, 1, 1));
    return createPartModel(std::move(parts));
}

osg::ref_ptr<const BrickModel> turn(const BrickModel& model)
{
    return change(model,
                  [](Part& part)
                  {
                      const int x = SIZE - part.cell[1] - part.size[1];
                      part.cell[1] = part.cell[0];
                      part.cell[0] = static_cast<std::uint16_t>(x);
                      std::swap(part.size[0], part.size[1]);
                  });
}

osg::ref_ptr<const BrickModel> mirror(const BrickModel& model)
{
    return change(model,
                  [](Part& part) { part.cell[0] = static_cast<std::uint16_t>(SIZE - part.cell[0] - part.size[0]); });
}

osg::ref_ptr<const BrickModel> tilt(const BrickModel& model)
{
    BrickGrid grid = model.getGrid();
    std::swap(grid.cellSize.y, grid.cellSize.z);
    grid.upAxis = UpAxis::Y;
    std::vector<Part> parts = model.getParts();
    for (Part& part : parts)
    {
        std::swap(part.cell[1], part.cell[2]);
        std::swap(part.size[1], part.size[2]);
    }
    return BrickModel::createOfParts(grid, std::move(parts));
}

} // namespace osgLego::test
