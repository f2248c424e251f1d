#pragma once

#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/SupportColumn.h>

#include <cstddef>
#include <vector>

namespace osgLego
{

/** A layout, and the means by which it was made to stand. */
struct SupportedLayout
{
    LayoutProblem problem; //!< with the cells that were added
    LaidParts parts;
    bool stands = true;
    bool isLaidAgain = false;             //!< whether parts differ from those of the first layout
    std::size_t numHiddenCells = 0;       //!< cells added where nobody sees them
    std::vector<SupportColumn> columns{}; //!< columns added below the model, those for its building plan last
    std::size_t numColumnParts = 0;       //!< their parts
    std::size_t numPropped = 0;           //!< pieces of the model that stand on columns of their own alone
    std::size_t numBuildingColumns = 0;   //!< of `columns`, those that make the building plan easier
    std::size_t largestSubmodel = 0;      //!< its parts; 0 if there is none, or if building was not planned
    std::size_t deepestSubmodel = 0;      //!< how deep submodels are nested; likewise
    std::size_t numFallingSteps = 0;      //!< steps after which the model has to be held; likewise
};

} // namespace osgLego
