#include <osgLego/model/LayoutPieces.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/model/LaidBox.h>

#include <algorithm>

namespace osgLego
{

LayoutPieces::LayoutPieces(const LaidParts& parts)
{
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        visitCells(toBox(parts[part]), [&](const glm::ivec3& cell) { _partOfCell.emplace(toCellKey(cell), part); });
    UnionFind sets;
    sets.reset(parts.size());
    for (const auto& [key, part] : _partOfCell)
        if (const auto above = _partOfCell.find(key + CELL_ABOVE); above != _partOfCell.end())
            sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(above->second));

    std::vector<std::size_t> numCells(parts.size());
    std::vector<std::uint32_t> roots;
    for (std::uint32_t part = 0; part < parts.size(); ++part)
    {
        const auto root = static_cast<std::uint32_t>(sets.find(static_cast<std::int32_t>(part)));
        if (root == part) roots.push_back(root);
        numCells[root] += static_cast<std::size_t>(parts[part].size[0]) * parts[part].size[1] * parts[part].size[2];
    }
    std::stable_sort(roots.begin(), roots.end(),
                     [&](std::uint32_t root, std::uint32_t other) { return numCells[root] > numCells[other]; });
    _pieceOfPart.resize(parts.size());
    for (std::uint32_t piece = 0; piece < roots.size(); ++piece)
        _pieceOfPart[roots[piece]] = piece;
    _cells.resize(roots.size());
    for (std::uint32_t part = 0; part < parts.size(); ++part)
    {
        _pieceOfPart[part] = _pieceOfPart[static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(part)))];
        visitCells(toBox(parts[part]), [&](const glm::ivec3& cell) { _cells[_pieceOfPart[part]].push_back(cell); });
    }
}

std::size_t LayoutPieces::countParts(std::uint32_t piece) const
{
    return static_cast<std::size_t>(std::count(_pieceOfPart.begin(), _pieceOfPart.end(), piece));
}

std::uint32_t LayoutPieces::find(const glm::ivec3& cell) const
{
    const auto part = _partOfCell.find(toCellKey(cell));
    return part == _partOfCell.end() ? NONE : _pieceOfPart[part->second];
}

} // namespace osgLego
