#include "../layout/LaidModel.h"

#include <osgLego/PartType.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Lists all layouts of a few cells, and finds the least number of components. */
class AllLayouts
{
public:
    explicit AllLayouts(const LayoutProblem& problem) : _problem(problem), _isCovered(problem.cells.size()) {}

    int findFewestComponents()
    {
        search(0);
        return _fewest;
    }

private:
    void search(std::size_t first)
    {
        while (first < _isCovered.size() && _isCovered[first])
            ++first;
        if (first == _isCovered.size())
        {
            _fewest = std::min(_fewest, LaidModel(_problem, _parts).countComponents());
            return;
        }
        for (const auto& [shorter, longer] : PART_SIZES)
        {
            lay(first, shorter, longer);
            if (shorter != longer) lay(first, longer, shorter);
        }
    }

    void lay(std::size_t first, int width, int depth)
    {
        const LayoutCell& corner = _problem.cells[first];
        std::vector<std::size_t> covered;
        for (std::size_t i = first; i < _problem.cells.size(); ++i)
        {
            const LayoutCell& cell = _problem.cells[i];
            const bool isInside = cell.place[2] == corner.place[2] && cell.place[0] >= corner.place[0] &&
                                  cell.place[0] < corner.place[0] + width && cell.place[1] >= corner.place[1] &&
                                  cell.place[1] < corner.place[1] + depth;
            if (isInside && !_isCovered[i] && cell.color == corner.color) covered.push_back(i);
        }
        if (covered.size() != static_cast<std::size_t>(width * depth)) return;
        for (const std::size_t cell : covered)
            _isCovered[cell] = true;
        _parts.push_back(
            {corner.place, {static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(depth), 1}, corner.color});
        search(first + 1);
        _parts.pop_back();
        for (const std::size_t cell : covered)
            _isCovered[cell] = false;
    }

    const LayoutProblem& _problem;
    std::vector<bool> _isCovered;
    LaidParts _parts;
    int _fewest = 1000000;
};

} // namespace

TEST(LayoutComponents, AreAsFewAsInTheBestOfAllLayouts)
{
    std::mt19937 random(1);
    for (int i = 0; i < 60; ++i)
    {
        const int numColors = 1 + i % 3;
        const LayoutProblem problem = makeCells(
            {3, 2, 2},
            [&](int, int, int)
            { return random() % 5 == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned int>(numColors)); },
            std::vector<LayoutColor>(3));
        const int fewest = AllLayouts(problem).findFewestComponents();
        EXPECT_EQ(LaidModel(problem, layOut(problem, {})).countComponents(), fewest) << "model " << i;
    }
}

TEST(LayoutComponents, FlatPlacesAsHighAsABrickAreOnePiece)
{
    // Without parts above and below, every brick would be a piece of its own.
    const auto isOfLetter = [](int x, int y) { return x < 3 || x >= 11 || (y >= 5 && y < 8); };
    const std::vector<std::pair<std::string, LayoutProblem>> models{
        {"slab", makeCells({13, 14, 3}, [](int, int, int) { return 0; })},
        {"beam", makeCells({40, 2, 3}, [](int, int, int) { return 0; })},
        {"rod", makeCells({30, 1, 3}, [](int, int, int) { return 0; })},
        {"letter", makeCells({14, 14, 3}, [&](int x, int y, int) { return isOfLetter(x, y) ? 0 : -1; })},
        {"table", makeCells({15, 9, 9}, [](int x, int y, int z)
                            { return z >= 6 || ((x < 2 || x >= 13) && (y < 2 || y >= 7)) ? 0 : -1; })}};
    for (auto [name, problem] : models)
        for (const Effort effort : {Effort::INSTANT, Effort::NORMAL, Effort::BEST})
        {
            problem.isOfPlates = true;
            LayoutOptions options;
            options.effort = effort;
            const LaidParts parts = layOut(problem, options);
            const LaidModel laid(problem, parts);
            EXPECT_EQ(laid.findMistake(), "") << name;
            EXPECT_EQ(laid.countComponents(), 1) << name << ", effort " << static_cast<int>(effort);
        }
}

} // namespace osgLego
