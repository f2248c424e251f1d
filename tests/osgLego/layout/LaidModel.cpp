#include "LaidModel.h"

#include <osgLego/PartType.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace osgLego
{

namespace
{

using Place = std::array<int, 3>;

Place getPlace(const LayoutCell& cell)
{
    return {cell.place[0], cell.place[1], cell.place[2]};
}

int countSets(int count, const std::set<std::pair<int, int>>& links)
{
    std::vector<int> labels(static_cast<std::size_t>(count));
    std::iota(labels.begin(), labels.end(), 0);
    for (bool hasChanged = true; hasChanged;)
    {
        hasChanged = false;
        for (const auto& [a, b] : links)
        {
            int& first = labels[static_cast<std::size_t>(a)];
            int& second = labels[static_cast<std::size_t>(b)];
            if (first == second) continue;
            first = second = std::min(first, second);
            hasChanged = true;
        }
    }
    return static_cast<int>(std::set<int>(labels.begin(), labels.end()).size());
}

} // namespace

LayoutProblem makeCells(const glm::ivec3& size, const std::function<int(int, int, int)>& getColor,
                        std::vector<LayoutColor> colors)
{
    LayoutProblem problem;
    problem.size = size;
    problem.colors = std::move(colors);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (const int color = getColor(x, y, z); color >= 0)
                    problem.cells.push_back(
                        {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)},
                         static_cast<std::uint16_t>(color)});
    return problem;
}

LayoutProblem makeRandomCells(const glm::ivec3& size, int percent, std::uint32_t seed, std::vector<LayoutColor> colors)
{
    std::mt19937 random(seed);
    std::vector<int> blots(1000);
    for (int& color : blots)
    {
        const auto choice = random() % (colors.size() + 1);
        color = choice == colors.size() ? LayoutCell::ANY_COLOR : static_cast<int>(choice);
    }
    return makeCells(
        size,
        [&](int x, int y, int z)
        {
            const auto blot = static_cast<std::size_t>((x / 4 + 7 * (y / 3) + 49 * (z / 2)) % 1000);
            return static_cast<int>(random() % 100) < percent ? blots[blot] : -1;
        },
        colors);
}

LayoutProblem makeDome(int radius, int thickness)
{
    const auto isInside = [](int x, int y, int z, int limit) { return x * x + y * y + z * z < limit * limit; };
    return makeCells({2 * radius, 2 * radius, radius},
                     [&](int x, int y, int z)
                     {
                         const bool isCell = isInside(x - radius, y - radius, z, radius) &&
                                             !isInside(x - radius, y - radius, z, radius - thickness);
                         return isCell ? 0 : -1;
                     });
}

LaidModel::LaidModel(const LayoutProblem& problem, const LaidParts& parts) : _problem(problem), _parts(parts)
{
    for (const LayoutCell& cell : problem.cells)
        _colors[getPlace(cell)] = cell.color;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (int z = 0; z < parts[i].size[2]; ++z)
            for (int y = 0; y < parts[i].size[1]; ++y)
                for (int x = 0; x < parts[i].size[0]; ++x, ++_numCovered)
                    _owners[{parts[i].place[0] + x, parts[i].place[1] + y, parts[i].place[2] + z}] =
                        static_cast<int>(i);
}

std::string LaidModel::findMistake() const
{
    if (_owners.size() != static_cast<std::size_t>(_numCovered)) return "a cell is covered twice";
    if (_owners.size() != _colors.size()) return "a cell is not covered";
    for (const auto& [place, owner] : _owners)
    {
        const auto cell = _colors.find(place);
        if (cell == _colors.end()) return "a place that is not a cell is covered";
        if (cell->second != LayoutCell::ANY_COLOR && cell->second != _parts[static_cast<std::size_t>(owner)].color)
            return "a part crosses a border between colours";
    }
    for (const LaidPart& part : _parts)
        if (std::string mistake = findMistake(part); !mistake.empty()) return mistake;
    return "";
}

std::string LaidModel::findMistake(const LaidPart& part) const
{
    if (part.color >= _problem.colors.size()) return "a part has an unknown colour";
    const bool isBrick = !_problem.isOfPlates || part.size[2] == 3;
    if (part.size[2] != (_problem.isOfPlates && isBrick ? 3 : 1)) return "a part has a wrong height";
    const PartType* const type =
        findPartType(isBrick ? PartFamily::BRICK : PartFamily::PLATE, part.size[0], part.size[1]);
    if (!type) return "there is no part of this size";
    const LayoutColor& color = _problem.colors[part.color];
    const bool isMade = ((isBrick ? color.bricks : color.plates) >> type->getSizeIndex() & 1) != 0;
    const bool isCell = part.size == std::array<std::uint8_t, 3>{1, 1, 1};
    return isMade || isCell ? "" : "a part was never made in its colour";
}

std::set<std::pair<int, int>> LaidModel::findContacts() const
{
    std::set<std::pair<int, int>> contacts;
    for (const auto& [place, owner] : _owners)
    {
        const auto above = _owners.find({place[0], place[1], place[2] + 1});
        if (above != _owners.end() && above->second != owner) contacts.emplace(owner, above->second);
    }
    return contacts;
}

int LaidModel::countComponents() const
{
    return countSets(static_cast<int>(_parts.size()), findContacts());
}

int LaidModel::countLeaves() const
{
    std::vector<int> degrees(_parts.size());
    for (const auto& [part, other] : findContacts())
    {
        ++degrees[static_cast<std::size_t>(part)];
        ++degrees[static_cast<std::size_t>(other)];
    }
    return static_cast<int>(std::count(degrees.begin(), degrees.end(), 1));
}

int LaidModel::countStackedSeams() const
{
    int count = 0;
    const auto find = [&](const Place& place)
    {
        const auto owner = _owners.find(place);
        return owner == _owners.end() ? -1 : owner->second;
    };
    for (const auto& [place, owner] : _owners)
        for (const Place& beside : {Place{place[0] + 1, place[1], place[2]}, Place{place[0], place[1] + 1, place[2]}})
        {
            const int other = find(beside);
            const int below = find({place[0], place[1], place[2] - 1});
            const int otherBelow = find({beside[0], beside[1], beside[2] - 1});
            const bool areJoints =
                other != -1 && other != owner && below != -1 && otherBelow != -1 && below != otherBelow;
            count += areJoints && (below != owner || otherBelow != other) ? 1 : 0;
        }
    return count;
}

} // namespace osgLego
