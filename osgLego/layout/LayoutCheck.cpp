#include <osgLego/layout/LayoutCheck.h>

#include <algorithm>
#include <tuple>

namespace osgLego
{

namespace
{

/** Checks the parts of a layout one by one. */
class LayoutCheck
{
public:
    explicit LayoutCheck(const LayoutProblem& problem) : _problem(problem), _isCovered(problem.cells.size(), false) {}

    std::string findError(const LaidParts& parts)
    {
        for (const LaidPart& part : parts)
            if (const std::string error = check(part); !error.empty()) return error;
        const auto open = std::find(_isCovered.begin(), _isCovered.end(), false);
        if (open == _isCovered.end()) return {};
        return "no part covers the cell " + toText(_problem.cells[static_cast<std::size_t>(open - _isCovered.begin())]);
    }

private:
    using Place = std::array<std::uint16_t, 3>;

    static std::string toText(const Place& place)
    {
        return std::to_string(place[0]) + " " + std::to_string(place[1]) + " " + std::to_string(place[2]);
    }
    static std::string toText(const LayoutCell& cell) { return toText(cell.place); }

    std::string check(const LaidPart& part)
    {
        if (!findPartType(_problem, part))
            return "the part at " + toText(part.place) + " has a size that does not exist";
        if (part.color >= _problem.colors.size())
            return "the part at " + toText(part.place) + " has a colour that does not exist";
        for (int z = 0; z < part.size[2]; ++z)
            for (int y = 0; y < part.size[1]; ++y)
                for (int x = 0; x < part.size[0]; ++x)
                {
                    const Place place{static_cast<std::uint16_t>(part.place[0] + x),
                                      static_cast<std::uint16_t>(part.place[1] + y),
                                      static_cast<std::uint16_t>(part.place[2] + z)};
                    if (const std::string error = cover(place, part.color); !error.empty()) return error;
                }
        return {};
    }

    std::string cover(const Place& place, std::uint16_t color)
    {
        const auto isBefore = [](const LayoutCell& cell, const Place& other)
        { return std::tie(cell.place[2], cell.place[1], cell.place[0]) < std::tie(other[2], other[1], other[0]); };
        const auto cell = std::lower_bound(_problem.cells.begin(), _problem.cells.end(), place, isBefore);
        if (cell == _problem.cells.end() || cell->place != place)
            return "a part covers " + toText(place) + ", not a cell";
        const auto index = static_cast<std::size_t>(cell - _problem.cells.begin());
        if (_isCovered[index]) return "two parts cover the cell " + toText(place);
        if (cell->color != LayoutCell::ANY_COLOR && cell->color != color)
            return "the part that covers the cell " + toText(place) + " has another colour";
        _isCovered[index] = true;
        return {};
    }

    const LayoutProblem& _problem;
    std::vector<bool> _isCovered;
};

} // namespace

const PartType* findPartType(const LayoutProblem& problem, const LaidPart& part)
{
    const bool isBrick = !problem.isOfPlates || part.size[2] == 3;
    if (part.size[2] != (problem.isOfPlates && isBrick ? 3 : 1)) return nullptr;
    return findPartType(isBrick ? PartFamily::BRICK : PartFamily::PLATE, part.size[0], part.size[1]);
}

bool isAvailable(const LayoutProblem& problem, const LaidPart& part)
{
    const PartType* type = findPartType(problem, part);
    const LayoutColor& color = problem.colors[part.color];
    const unsigned int sizes = type->family == PartFamily::BRICK ? color.bricks : color.plates;
    return (sizes >> type->getSizeIndex() & 1u) != 0;
}

std::string findLayoutError(const LayoutProblem& problem, const LaidParts& parts)
{
    return LayoutCheck(problem).findError(parts);
}

} // namespace osgLego
