#pragma once

#include <cstddef>
#include <string>

namespace osgLego
{

/** A list of names for a message, which is short for any number of them: "'a.png', 'b.png' and 3 more".
 *
 * @param names any range with a size. @param most listed names, at least one. @param toText makes the text of a name.
 * May be called from any thread. */
template <typename Names, typename ToText>
std::string listNames(const Names& names, std::size_t most, const ToText& toText)
{
    std::string list;
    std::size_t numListed = 0;
    for (const auto& name : names)
    {
        if (numListed == most) return list + " and " + std::to_string(names.size() - most) + " more";
        list += (list.empty() ? "" : ", ") + toText(name);
        ++numListed;
    }
    return list;
}

} // namespace osgLego
