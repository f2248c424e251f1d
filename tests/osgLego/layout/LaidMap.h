#pragma once

#include <osgLego/layout/PartColors.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/layout/PartSizes.h>

#include <random>
#include <utility>

namespace osgLego
{

/** A layout of some cells while it is computed, together with all that it refers to. */
struct LaidMap
{
    explicit LaidMap(LayoutProblem cells) : problem(std::move(cells)) {}
    LaidMap(const LaidMap&) = delete;
    LaidMap& operator=(const LaidMap&) = delete;

    /** Cover all cells by random parts. */
    void layRandomly(std::mt19937& random);
    /** All cells must be covered. */
    LaidParts getParts() const { return collectParts(map, sizes); }
    /** Count the components. Fails if a cell is not covered once by a part that exists. */
    int countComponents() const;

    const LayoutProblem problem;
    const CellLattice lattice{problem};
    const PartSizes sizes{problem};
    PartMap map{lattice};

private:
    bool fits(CellLattice::Index anchor, const PartShape& shape) const;
};

} // namespace osgLego
