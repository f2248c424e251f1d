#pragma once

#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/ConnectionBuilder.h>

namespace osgLego
{

/** Remove added cells from a layout without which it has no more pieces: parts of added cells alone, and the added
 * cells at the ends of other parts. The rest of the layout stays. */
void removeUnneededCells(JoinedLayout& layout);

} // namespace osgLego
