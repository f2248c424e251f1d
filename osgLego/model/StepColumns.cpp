#include <osgLego/model/StepColumns.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/model/LaidBox.h>

#include <unordered_set>

namespace osgLego
{

StepColumns::StepColumns(const SupportedLayout& layout, const std::vector<std::uint32_t>& ranks,
                         const std::function<bool()>& isCancelled) :
    _columns(layout, isCancelled),
    _order(layout.parts.size()), _isCancelled(isCancelled)
{
    for (std::size_t part = 0; part < ranks.size(); ++part)
        _order[ranks[part]] = layout.parts[part];
}

bool StepColumns::run(const std::vector<std::size_t>& numsPlaced, std::size_t mostCells)
{
    for (const std::size_t numPlaced : numsPlaced)
    {
        const auto selectPlaced = [&](const LaidParts& parts) { return select(parts, numPlaced); };
        // Later steps may need smaller columns.
        if (!_columns.standWith(selectPlaced, mostCells) && _isCancelled && _isCancelled()) return false;
    }
    return true;
}

/** The first parts in the order of placing, and all columns that were added. */
std::vector<std::uint32_t> StepColumns::select(const LaidParts& parts, std::size_t numPlaced) const
{
    std::unordered_set<CellKey> later;
    for (std::size_t rank = numPlaced; rank < _order.size(); ++rank)
        later.insert(toCellKey(toBox(_order[rank]).lower));
    std::vector<std::uint32_t> selected;
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        if (!later.contains(toCellKey(toBox(parts[part]).lower))) selected.push_back(part);
    return selected;
}

} // namespace osgLego
