#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>

namespace osgLego
{

/** A layout, and the means by which it was made to stand. */
struct SupportedLayout
{
    LayoutProblem problem; //!< with the cells of columns
    LaidParts parts;
    bool stands = true;
    bool isLaidAgain = false;       //!< whether parts differ from those of the first layout
    std::size_t numColumns = 0;     //!< columns added below the model
    std::size_t numColumnParts = 0; //!< their parts
};

} // namespace osgLego
