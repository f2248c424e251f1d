#pragma once

#include <string>
#include <utility>
#include <vector>

namespace osgLego
{

/** What a contender may be besides, when it knows the parts that its time is made of. */
class StageTimes
{
public:
    virtual ~StageTimes() = default;

    /** The names of parts of the last run, and their milliseconds; the same names after every run. The part "gpu" is
     * that between GL's own time stamps, and is there only where these are a GPU's. */
    virtual std::vector<std::pair<std::string, double>> getStageTimes() const = 0;
};

} // namespace osgLego
