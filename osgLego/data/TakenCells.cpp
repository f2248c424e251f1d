#include <osgLego/data/TakenCells.h>

#include <algorithm>

namespace osgLego
{

bool TakenCells::overlap(std::span<const Part> parts)
{
    TakenCells taken;
    return !std::all_of(parts.begin(), parts.end(), [&taken](const Part& part) { return taken.take(part); });
}

bool TakenCells::take(const Part& part)
{
    const glm::ivec3 end = part.getCell() + part.getSize();
    for (int z = part.cell[2]; z < end.z; ++z)
        for (int y = part.cell[1]; y < end.y; ++y)
            for (int x = part.cell[0]; x < end.x; ++x)
                if (!take(glm::ivec3(x, y, z))) return false;
    return true;
}

bool TakenCells::take(const glm::ivec3& cell)
{
    const glm::ivec3 block = cell / SIDE;
    const glm::ivec3 place = cell % SIDE;
    const auto key = [&block](int axis) { return static_cast<std::uint64_t>(block[axis]); };
    std::uint64_t& bits = _blocks[key(0) << 40 | key(1) << 20 | key(2)];
    const std::uint64_t bit = std::uint64_t(1) << (place.x + SIDE * (place.y + SIDE * place.z));
    const bool isFree = (bits & bit) == 0;
    bits |= bit;
    return isFree;
}

} // namespace osgLego
