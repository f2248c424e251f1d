#include "ArgumentCheck.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace osgLego
{

namespace
{

/** The fewest letters to insert, remove, replace or exchange with the next one (optimal string alignment distance). */
std::size_t countMistakes(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> counts(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
            if (i == 0 || j == 0)
            {
                counts[i][j] = i + j;
                continue;
            }
            counts[i][j] = std::min(
                {counts[i - 1][j] + 1, counts[i][j - 1] + 1, counts[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                counts[i][j] = std::min(counts[i][j], counts[i - 2][j - 2] + 1);
        }
    return counts[a.size()][b.size()];
}

/** A sentence on an option that does not exist, with the name that is spelled like it, if any. */
std::string describeUnknownOption(const std::string& name, const std::vector<std::string>& known)
{
    // With two mistakes, short names are spelled like unrelated ones.
    const std::size_t mostMistakes = std::min<std::size_t>(2, (name.size() - 2) / 3);
    const auto hasFewer = [&](const std::string& a, const std::string& b)
    { return countMistakes(name, a) < countMistakes(name, b); };
    const auto closest = std::min_element(known.begin(), known.end(), hasFewer);
    const bool isClose = closest != known.end() && countMistakes(name, *closest) <= mostMistakes;
    return "there is no option " + name + (isClose ? "; expected " + *closest : "; --help lists all");
}

std::vector<std::string> listOptions(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

} // namespace

void checkArguments(const CLI::App& app, int argc, char** argv)
{
    for (int index = 1; index < argc; ++index)
    {
        const std::string argument = argv[index];
        if (argument == "--") return; // what follows are files
        if (!argument.starts_with('-')) continue;
        const std::string name = argument.substr(0, argument.find('='));
        const CLI::Option* option = app.get_option_no_throw(name);
        if (!option && !argument.starts_with("--")) continue;
        if (!option) throw CLI::ValidationError(describeUnknownOption(name, listOptions(app)));
        if (argument == name + "=")
            throw CLI::ValidationError(name + " is empty; expected " + argument + option->get_type_name());
        if (argument == name && option->get_items_expected_min() > 0) ++index; // its value, which may begin with dashes
    }
}

} // namespace osgLego
