#include <osgLego/layout/Layout.h>

namespace osgLego
{

LaidParts layOut(const LayoutProblem& problem, const LayoutOptions&, const LaidParts&)
{
    LaidParts parts;
    for (const LayoutCell& cell : problem.cells)
        parts.push_back({cell.place, {1, 1, 1}, cell.color == LayoutCell::ANY_COLOR ? std::uint16_t{0} : cell.color});
    return parts;
}

} // namespace osgLego
