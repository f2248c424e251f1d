#include "Layouts.h"

#include <osgLego/PartType.h>

#include <algorithm>
#include <map>
#include <random>

namespace osgLego
{

namespace
{

/** Lays the cells of a problem in every way, from the first cell to the last. */
class AllLayouts
{
public:
    AllLayouts(const LayoutProblem& problem, const std::function<void(const LaidParts&)>& visit) :
        _problem(problem), _visit(visit)
    {
        for (const LayoutCell& cell : problem.cells)
            _open.emplace(cell.place, cell.color);
        visitRest();
    }

private:
    using Place = std::array<std::uint16_t, 3>;

    void visitRest()
    {
        const auto first = std::find_if(_problem.cells.begin(), _problem.cells.end(),
                                        [this](const LayoutCell& cell) { return _open.contains(cell.place); });
        if (first == _problem.cells.end())
        {
            _visit(_parts);
            return;
        }
        for (std::size_t size = 0; size < PART_SIZES.size(); ++size)
        {
            const auto [width, length] = PART_SIZES[size];
            visitPart(first->place, width, length, size);
            if (width != length) visitPart(first->place, length, width, size);
        }
    }

    void visitPart(const Place& place, int width, int length, std::size_t size)
    {
        for (std::uint16_t color = 0; color < _problem.colors.size(); ++color)
        {
            if ((_problem.colors[color].bricks >> size & 1) == 0) continue;
            const std::map<Place, std::uint16_t> before = _open;
            if (take(place, width, length, color))
            {
                _parts.push_back(
                    {place, {static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(length), 1}, color});
                visitRest();
                _parts.pop_back();
            }
            _open = before;
        }
    }

    bool take(const Place& place, int width, int length, std::uint16_t color)
    {
        for (int y = 0; y < length; ++y)
            for (int x = 0; x < width; ++x)
            {
                const auto cell = _open.find(
                    {static_cast<std::uint16_t>(place[0] + x), static_cast<std::uint16_t>(place[1] + y), place[2]});
                if (cell == _open.end()) return false;
                if (cell->second != LayoutCell::ANY_COLOR && cell->second != color) return false;
                _open.erase(cell);
            }
        return true;
    }

    const LayoutProblem& _problem;
    const std::function<void(const LaidParts&)>& _visit;
    std::map<Place, std::uint16_t> _open;
    LaidParts _parts;
};

void addCell(LayoutProblem& problem, const glm::ivec3& place, char character)
{
    if (character == '.') return;
    LayoutCell cell;
    cell.place = {static_cast<std::uint16_t>(place.x), static_cast<std::uint16_t>(place.y),
                  static_cast<std::uint16_t>(place.z)};
    if (character != '*') cell.color = static_cast<std::uint16_t>(character - 'a');
    problem.cells.push_back(cell);
    const std::size_t numColors = character == '*' ? 1 : cell.color + std::size_t{1};
    problem.colors.resize(std::max(problem.colors.size(), numColors));
}

} // namespace

LayoutProblem drawProblem(const std::vector<std::vector<std::string>>& layers)
{
    LayoutProblem problem;
    problem.size.z = static_cast<int>(layers.size());
    for (int z = 0; z < problem.size.z; ++z)
    {
        const std::vector<std::string>& rows = layers[static_cast<std::size_t>(z)];
        problem.size.y = std::max(problem.size.y, static_cast<int>(rows.size()));
        for (int y = 0; y < static_cast<int>(rows.size()); ++y)
        {
            const std::string& row = rows[static_cast<std::size_t>(y)];
            problem.size.x = std::max(problem.size.x, static_cast<int>(row.size()));
            for (int x = 0; x < static_cast<int>(row.size()); ++x)
                addCell(problem, {x, y, z}, row[static_cast<std::size_t>(x)]);
        }
    }
    return problem;
}

LayoutProblem createRandomProblem(const glm::ivec3& size, const std::string& characters, unsigned int seed)
{
    std::mt19937 engine(seed);
    LayoutProblem problem;
    problem.size = size;
    problem.colors.resize(1);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                addCell(problem, {x, y, z}, characters[engine() % characters.size()]);
    return problem;
}

void forEachLayout(const LayoutProblem& problem, const std::function<void(const LaidParts&)>& visit)
{
    AllLayouts(problem, visit);
}

} // namespace osgLego
