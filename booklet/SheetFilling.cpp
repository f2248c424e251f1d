#include "SheetFilling.h"

#include <algorithm>

namespace osgLego
{

SheetFilling::SheetFilling(std::span<const Block> blocks, std::size_t numColumns, double capacity) :
    _costs(numColumns + 1), _firsts(numColumns + 1)
{
    constexpr double TOLERANCE = 1e-9;
    _costs[0] = {0.0};
    for (std::size_t column = 1; column <= numColumns; ++column)
        for (std::size_t first = 0; first < std::min(_costs[column - 1].size(), blocks.size()); ++first)
        {
            if (_costs[column - 1][first] >= IMPOSSIBLE) continue;
            double height = 0.0;
            for (std::size_t end = first + 1; end <= blocks.size(); ++end)
            {
                height += blocks[end - 1].height;
                const double free = (capacity - height) / capacity;
                if (free < -TOLERANCE) break;
                if (end >= _costs[column].size())
                {
                    _costs[column].resize(end + 1, IMPOSSIBLE);
                    _firsts[column].resize(end + 1, 0);
                }
                const double cost =
                    _costs[column - 1][first] + free * free + (column < numColumns ? blocks[end - 1].endCost : 0.0);
                if (cost >= _costs[column][end]) continue;
                _costs[column][end] = cost;
                _firsts[column][end] = first;
            }
        }
    if (_costs.back().empty()) _costs.back() = {IMPOSSIBLE};
}

double SheetFilling::getCost(std::size_t numBlocks) const
{
    const double cost = _costs.back()[numBlocks];
    return cost >= IMPOSSIBLE ? IMPOSSIBLE : cost / static_cast<double>(_costs.size() - 1);
}

std::vector<std::size_t> SheetFilling::findEnds(std::size_t numBlocks) const
{
    std::vector<std::size_t> ends(_costs.size() - 1);
    for (std::size_t column = ends.size(); column > 0; --column)
    {
        ends[column - 1] = numBlocks;
        numBlocks = _firsts[column][numBlocks];
    }
    return ends;
}

} // namespace osgLego
