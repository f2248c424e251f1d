#include <osgLego/model/StepColumns.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/model/LaidBox.h>

#include <unordered_set>

namespace osgLego
{

namespace
{

/** The places of the parts that follow the first ones in an order. */
std::unordered_set<CellKey> findLater(const std::vector<LaidPart>& order, std::size_t numPlaced)
{
    std::unordered_set<CellKey> later;
    for (std::size_t rank = numPlaced; rank < order.size(); ++rank)
        later.insert(toCellKey(toBox(order[rank]).lower));
    return later;
}

/** All parts but those at some places, so also the columns that were added. */
std::vector<std::uint32_t> selectOthers(const LaidParts& parts, const std::unordered_set<CellKey>& places)
{
    std::vector<std::uint32_t> selected;
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        if (!places.contains(toCellKey(toBox(parts[part]).lower))) selected.push_back(part);
    return selected;
}

} // namespace

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
        const std::unordered_set<CellKey> later = findLater(_order, numPlaced);
        const auto select = [&later](const LaidParts& parts) { return selectOthers(parts, later); };
        // Later steps may need smaller columns.
        if (!_columns.standWith(select, mostCells) && _isCancelled && _isCancelled()) return false;
    }
    return true;
}

} // namespace osgLego
