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

/** Those of some names, or all when there is no name. A name with a '=' is a text of LegoSettings, of the method that a
 * LegoNode is to use. Throws std::runtime_error for any other name that no contender has. */
ContenderList createContenders(const std::vector<std::string>& names);

} // namespace osgLego
