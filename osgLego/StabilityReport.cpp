#include <osgLego/StabilityReport.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <sstream>

namespace osgLego
{

namespace
{

std::string countParts(std::size_t count)
{
    return std::to_string(count) + (count == 1 ? " part is" : " parts are");
}

std::string describeFall(std::size_t numTipping, std::size_t numUnheld)
{
    std::string text;
    if (numTipping > 0)
        text = std::to_string(numTipping) + (numTipping == 1 ? " part tips" : " parts tip") +
               " over as a whole, since the centre of mass is not above the foot";
    if (numUnheld > 0) text += (text.empty() ? "" : "; ") + countParts(numUnheld) + " not held";
    return text;
}

} // namespace

std::vector<std::uint32_t> StabilityReport::findUnheld() const
{
    std::vector<std::uint32_t> unheld;
    std::set_difference(falling.begin(), falling.end(), tipping.begin(), tipping.end(), std::back_inserter(unheld));
    return unheld;
}

std::string StabilityReport::toString() const
{
    std::ostringstream text;
    if (falls())
        text << "the model falls: " << describeFall(tipping.size(), findUnheld().size());
    else if (!stands)
        text << "it is unknown whether the model stands";
    else
        text << "the model stands"
             << (safe                             ? " safely"
                 : isMarginBound && !tipsEasily() ? ", but maybe not safely"
                                                  : ", but not safely")
             << ", with a margin of " << (isMarginBound ? "at least " : "") << std::lround(100.0 * margin) << " %";
    if (stands && tippingAngle)
        text << "; on a table that tilts, it would tip as a whole at " << std::fixed << std::setprecision(1)
             << *tippingAngle << " degrees";
    if (stands && tiltAngles)
    {
        const double leastTilt = *std::min_element(tiltAngles->begin(), tiltAngles->end());
        // It may tip in another direction than those of the tilts.
        const double least = std::min(leastTilt, tippingAngle.value_or(MOST_TILT));
        const bool isMore = least >= MOST_TILT || (isTiltBound && least == leastTilt);
        text << "; it stands on a base that is tilted by " << std::fixed << std::setprecision(1) << least << " degrees"
             << (isMore ? ", or more" : ", but not more");
    }
    if (!unknown.empty())
        text << "; " << countParts(unknown.size()) << " in a piece whose forces can't be computed precisely enough";
    return text.str();
}

} // namespace osgLego
