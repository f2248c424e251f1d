#include "ReportParts.h"

#include <algorithm>

#include <fmt/format.h>

namespace osgLego
{

using nlohmann::ordered_json;

std::string formatEnvironment(const BenchEnvironment& environment, const std::string& prefix)
{
    std::string text;
    for (const auto& [name, value] : environment.toFields())
        text += fmt::format("{}{}: {}\n", prefix, name, value);
    return text;
}

std::string formatGoals(const std::vector<Goal>& goals)
{
    if (goals.empty()) return {};
    std::size_t width = 24;
    for (const Goal& goal : goals)
        width = std::max(width, goal.text.size());
    std::string text = fmt::format("\nGoals, and what this run says; figures without a unit are ratios\n\n"
                                   "| {:{}} | {:24} | {:>12} | {:>12} | reached |\n"
                                   "|{:-<{}}|{:-<26}|{:->14}|{:->14}|---------|\n",
                                   "what", width, "where", "figure", "goal", "", width + 2, "", "", "");
    for (const Goal& goal : goals)
        text += fmt::format("| {:{}} | {:24} | {:>12} | {:>12} | {:7} |\n", goal.text, width, goal.where,
                            goal.getFigureText(), goal.getBoundText(), goal.isReached ? "yes" : "no");
    return text;
}

std::string formatCsvHead(const BenchEnvironment& environment, const std::vector<Goal>& goals)
{
    std::string text = formatEnvironment(environment, "# ");
    for (const Goal& goal : goals)
        text += fmt::format("# goal: {}; {}: {}, goal {}, {}\n", goal.text, goal.where, goal.getFigureText(),
                            goal.getBoundText(), goal.isReached ? "reached" : "not reached");
    return text;
}

std::string quotedField(std::string text)
{
    for (auto place = text.find('"'); place != std::string::npos; place = text.find('"', place + 2))
        text.insert(place, 1, '"');
    return '"' + text + '"';
}

ordered_json toJson(const BenchEnvironment& environment)
{
    ordered_json json;
    for (const auto& [name, value] : environment.toFields())
        json[name] = value;
    return json;
}

ordered_json toJson(const Spread& milliseconds)
{
    return {{"median", milliseconds.median},
            {"minimum", milliseconds.minimum},
            {"lowerQuartile", milliseconds.lowerQuartile},
            {"upperQuartile", milliseconds.upperQuartile},
            {"maximum", milliseconds.maximum}};
}

ordered_json toJson(const std::vector<Goal>& goals)
{
    ordered_json json = ordered_json::array();
    for (const Goal& goal : goals)
        json.push_back({{"what", goal.text},
                        {"where", goal.where},
                        {"figure", goal.figure},
                        {"unit", goal.unit},
                        {"goal", goal.getBoundText()},
                        {"reached", goal.isReached}});
    return json;
}

} // namespace osgLego
