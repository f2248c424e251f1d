#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <common/JsonValue.h>
#include <common/LayoutBound.h>

#include <string>
#include <vector>

namespace osgLego
{

/** Lower bounds of layouts, which take minutes to compute, in a file. */
class BoundCache
{
public:
    /** Read a file, if it exists. Throws std::runtime_error if it has other contents.
     * @param fileName empty keeps bounds in memory. */
    explicit BoundCache(std::string fileName);

    /** The bounds of some layers, from the file or computed now and added to it, in small groups, so that an
     * interrupted run loses little. Throws std::runtime_error.
     * @param seconds the time for each connected region of a layer. */
    std::vector<LayerBound> getBounds(const LayoutProblem& problem, const std::vector<int>& layers, double seconds);

private:
    void compute(const LayoutProblem& problem, const std::vector<int>& layers, double seconds);
    void write() const;

    std::string _fileName;
    JsonValue _entries = JsonValue::createObject(); //!< parts and isOptimum of layers, by hash
};

} // namespace osgLego
