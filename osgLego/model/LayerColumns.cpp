#include <osgLego/model/LayerColumns.h>

#include <osgLego/model/LayoutStanding.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace osgLego
{

namespace
{

// Groups of falling parts below which a column is tried, the largest first.
constexpr std::size_t MOST_GROUPS = 3;

/** The parts that begin in a layer or below it, without groups of hanging parts that are small.
 * @return indices in ascending order. */
std::vector<std::uint32_t> selectUpTo(int layer, const LaidParts& parts, std::size_t mostHanging)
{
    std::vector<bool> isSubmodel(parts.size(), false);
    for (const std::vector<std::uint32_t>& group : findHangingGroups(parts))
        if (group.size() <= mostHanging)
            for (const std::uint32_t part : group)
                isSubmodel[part] = true;
    std::vector<std::uint32_t> selected;
    for (std::uint32_t part = 0; part < parts.size() && parts[part].place[2] <= layer; ++part)
        if (!isSubmodel[part]) selected.push_back(part);
    return selected;
}

} // namespace

LayerColumns::LayerColumns(const SupportedLayout& layout, std::size_t mostHanging, double mostAdded,
                           const std::function<bool()>& isCancelled) :
    _layout(layout),
    _mostHanging(mostHanging), _isCancelled(isCancelled),
    _mostCells(static_cast<std::size_t>((1.0 + mostAdded) * static_cast<double>(layout.problem.cells.size())))
{
}

bool LayerColumns::run()
{
    std::set<int> layers;
    for (const LaidPart& part : _layout.parts)
        layers.insert(part.place[2]);
    for (const int layer : layers)
        if (!standUpTo(layer)) return false;
    return true;
}

/** Add columns until none of the parts up to a layer fall, or until no column helps. @return as run(). */
bool LayerColumns::standUpTo(int layer)
{
    for (bool isAdded = true; isAdded;)
    {
        PartList falling;
        if (!findFalling(_layout, layer, falling)) return false;
        if (falling.empty()) return true;
        isAdded = false;
        PartGroups groups = findTouchingGroups(_layout.parts, falling);
        groups.resize(std::min(groups.size(), MOST_GROUPS));
        for (const PartList& group : groups)
        {
            if (!addBelow(group, layer, falling.size(), isAdded)) return false;
            if (isAdded) break;
        }
        if (_layout.problem.cells.size() > _mostCells) return false;
    }
    return true;
}

/** Add the column after which the fewest parts fall, if that helps.
 * @param numFalling those that fall without it. @return false if it was cancelled. */
bool LayerColumns::addBelow(const PartList& group, int layer, std::size_t numFalling, bool& isAdded)
{
    std::optional<SupportColumn> best;
    for (const SupportColumn& place : SupportColumns(_layout.problem, _layout.parts).find(group))
    {
        PartList falling;
        if (!findFalling(addColumns(_layout, {place}), layer, falling)) return false;
        if (falling.size() >= numFalling) continue;
        numFalling = falling.size();
        best = place;
        if (numFalling == 0) break;
    }
    if (best) _layout = addColumns(_layout, {*best});
    isAdded = best.has_value();
    return true;
}

/** @param falling of the parts up to the layer, indices in ascending order. @return false if it was cancelled. */
bool LayerColumns::findFalling(const SupportedLayout& layout, int layer, PartList& falling) const
{
    const PartList selected = selectUpTo(layer, layout.parts, _mostHanging);
    LaidParts parts;
    parts.reserve(selected.size());
    for (const std::uint32_t part : selected)
        parts.push_back(layout.parts[part]);
    const std::optional<StabilityReport> report = computeStanding(layout.problem, parts, _isCancelled);
    if (!report) return false;
    for (const std::uint32_t part : report->falling)
        falling.push_back(selected[part]);
    return true;
}

} // namespace osgLego
