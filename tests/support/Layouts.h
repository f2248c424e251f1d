#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <functional>
#include <string>
#include <vector>

namespace osgLego
{

/** Create a problem from pictures of its layers, the lowest first, each a list of rows, y upwards. 'a' to 'z' are
 * colours 0 to 25, '*' is a cell of any colour, and '.' is empty. All colours exist in all sizes. */
LayoutProblem drawProblem(const std::vector<std::vector<std::string>>& layers);

/** Create a problem of random cells. @param characters those of drawProblem(), each equally likely. */
LayoutProblem createRandomProblem(const glm::ivec3& size, const std::string& characters, unsigned int seed);

/** Call a function with every layout of a problem of bricks, built from sizes that exist. */
void forEachLayout(const LayoutProblem& problem, const std::function<void(const LaidParts&)>& visit);

} // namespace osgLego
