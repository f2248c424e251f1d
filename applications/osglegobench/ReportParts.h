#pragma once

#include "BenchEnvironment.h"
#include "Goals.h"
#include "Spread.h"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace osgLego
{

// What all reports of the bench have in common.

/** Where it was measured, a line each.
 * @param prefix before each line. */
std::string formatEnvironment(const BenchEnvironment& environment, const std::string& prefix);

/** A table for people, in Markdown; empty without goals. */
std::string formatGoals(const std::vector<Goal>& goals);

/** The lines that CSV begins with: where it was measured, and the goals. Each begins with #. */
std::string formatCsvHead(const BenchEnvironment& environment, const std::vector<Goal>& goals);

/** A text as a field of CSV. */
std::string quotedField(std::string text);

nlohmann::ordered_json toJson(const BenchEnvironment& environment);
nlohmann::ordered_json toJson(const Spread& milliseconds);
nlohmann::ordered_json toJson(const std::vector<Goal>& goals);

} // namespace osgLego
