#include <osgLego/LayoutStatistics.h>

#include <iomanip>
#include <sstream>

namespace osgLego
{

namespace
{

std::string counted(std::size_t count, const char* singular, const char* plural)
{
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

/** One sentence on the changes by which a model was made to stand. */
std::string describe(const SupportStatistics& support)
{
    std::string text = "support: ";
    if (!support.isLaidAgain && support.numColumns == 0)
        text += support.stands ? "the model stands without it" : "nothing was found that helps";
    if (support.isLaidAgain) text += "parts were laid again";
    if (support.numColumns > 0)
        text += (support.isLaidAgain ? ", and " : "") + counted(support.numColumns, "column", "columns") + " of " +
                counted(support.numColumnParts, "part", "parts") + (support.numColumns == 1 ? " was" : " were") +
                " added";
    const bool wasChanged = support.isLaidAgain || support.numColumns > 0;
    return text + (!support.stands ? "; the model still falls" : wasChanged ? "; the model stands" : "");
}

} // namespace

std::string LayoutStatistics::toString() const
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(3);
    text << counted(numParts, "part", "parts") << " in " << counted(numColors, "colour", "colours") << " for "
         << counted(numCells, "cell", "cells") << ", " << numInterior << " of them inside";
    if (lowerBound) text << "; the fewest possible, layer by layer: " << *lowerBound;
    text << '\n'
         << counted(numComponents, "piece", "pieces") << ", where the cells allow " << numComponentsPossible << "; "
         << counted(numFloating, "part floats", "parts float") << ", and "
         << counted(numArticulationParts, "part holds", "parts hold") << " a piece together alone\n";
    text << "stacked seams: " << std::setprecision(1) << 100.0 * stackedSeams << " %, a length of " << stackedLength
         << "; colour error: " << meanColorError << " on average, at most " << maximumColorError << " in CIEDE2000";
    if (numUnavailable > 0)
        text << '\n'
             << counted(numUnavailable, "part has a size that was never made in its colour",
                        "parts have sizes that were never made in their colour");
    if (support) text << '\n' << describe(*support);
    return text.str();
}

} // namespace osgLego
