#pragma once

#include <osgLego/PartType.h>
#include <osgLego/layout/LayoutProblem.h>

#include <string>

namespace osgLego
{

/** The type of a part of a layout; null if there is none of its size. */
const PartType* findPartType(const LayoutProblem& problem, const LaidPart& part);

/** Whether the size of a part was ever made in its colour.
 * @param part has a size and a colour that exist. */
bool isAvailable(const LayoutProblem& problem, const LaidPart& part);

/** Check that parts cover every cell once and nothing else, in its colour, and have sizes that exist in any colour.
 * @return one sentence about the first error; empty if there is none. */
std::string findLayoutError(const LayoutProblem& problem, const LaidParts& parts);

} // namespace osgLego
