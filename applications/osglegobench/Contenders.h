#pragma once

#include "Contender.h"

#include <memory>
#include <string>
#include <vector>

namespace osgLego
{

using ContenderList = std::vector<std::unique_ptr<Contender>>;

// Contenders by the names that goals and plots look for.
inline constexpr const char* POINTS_PROJECTED = "points, projected"; //!< the paper's own
inline constexpr const char* POINTS_ADDRESSED = "points, addressed";
inline constexpr const char* EXACT_PASSES = "exact, passes";
inline constexpr const char* EXACT_NODE = "exact, node"; //!< whatever a LegoNode chooses by itself
inline constexpr const char* EXACT_CPU = "exact, cpu";
inline constexpr const char* PASSALIS = "passalis";
inline constexpr const char* DOMINANT_AXIS = "dominant axis";
inline constexpr const char* PLAIN_LOOP = "plain loop";
inline constexpr const char* OPENVDB = "openvdb";
inline constexpr const char* OPENVDB_NARROW = "openvdb, narrow";

/** All there are, in the order of tables. */
ContenderList createContenders();

/** Those of some names, or all when there is no name. Throws std::runtime_error for a name that nobody has. */
ContenderList createContenders(const std::vector<std::string>& names);

} // namespace osgLego
