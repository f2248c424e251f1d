#pragma once

#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/search/LayoutOptions.h>

namespace osgLego
{

/** Cover every cell with one part, of a size that exists in its colour.
 *
 * @param previous a layout of similar cells: its parts are kept where the cells are the same. Empty if there is none.
 * @return parts sorted by z, y and x of their place, the same for any number of threads; empty if it was cancelled. */
LaidParts layOut(const LayoutProblem& problem, const LayoutOptions& options, const LaidParts& previous = {});

} // namespace osgLego
