#include <osgLego/StabilityReport.h>

#include <cmath>
#include <sstream>

namespace osgLego
{

std::string StabilityReport::toString() const
{
    std::ostringstream text;
    if (!stands)
        text << "the model falls: " << falling.size() << (falling.size() == 1 ? " part is" : " parts are")
             << " not held";
    else
        text << "the model stands" << (safe ? " safely" : ", but not safely") << ", with a margin of "
             << std::lround(100.0 * margin) << " %";
    return text.str();
}

} // namespace osgLego
