#pragma once

#include "Contender.h"

#include <memory>
#include <string>
#include <vector>

namespace osgLego
{

using ContenderList = std::vector<std::unique_ptr<Contender>>;

/** All contenders, in the order of tables. */
ContenderList createContenders();

/** The contenders with the given names, or all if there are none. A name that contains '=' is a text of LegoSettings:
 * the method to be used by a LegoNode. Throws std::runtime_error for an unknown name. */
ContenderList createContenders(const std::vector<std::string>& names);

} // namespace osgLego
