#include <osgLego/model/LayerColumns.h>

#include <osgLego/model/PartGroups.h>

#include <set>

namespace osgLego
{

namespace
{

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

bool LayerColumns::run(std::size_t mostCells)
{
    std::set<int> layers;
    for (const LaidPart& part : getLayout().parts)
        layers.insert(part.place[2]);
    for (const int layer : layers)
    {
        const auto select = [&](const LaidParts& parts) { return selectUpTo(layer, parts, _mostHanging); };
        if (!_columns.standWith(select, mostCells)) return false;
    }
    return true;
}

} // namespace osgLego
