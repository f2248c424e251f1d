#pragma once

#include "LDrawColors.h"
#include "LDrawLattice.h"

#include <osgLego/BrickModel.h>

#include <set>

namespace osgLego
{

/** The bricks of the parts in a document, and the parts that can't be bricks. */
struct LDrawBricks
{
    static constexpr double MILLIMETRES = 0.4; //!< of 1 LDU

    osg::ref_ptr<const BrickModel> model; //!< null if there are no bricks; in millimetres, z upwards
    std::vector<LDrawPart> offLattice;    //!< inclined, scaled, or between the cells of the others
    std::vector<LDrawPart> overlapping;   //!< in a cell of an earlier part
    std::set<std::int32_t> unknownColors;

    /** Put parts into a grid: of bricks if all parts are bricks in common layers, otherwise of plates.
     * @return no model, with one sentence in `error`, if the grid would have too many cells. */
    static LDrawBricks create(std::span<const LDrawPart> parts, const LDrawColors& colors, std::string& error);
};

} // namespace osgLego
