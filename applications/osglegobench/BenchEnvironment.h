#pragma once

#include <string>
#include <utility>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego
{

/** Where and when something was measured: what stands in every file that the bench writes. */
struct BenchEnvironment
{
    std::string renderer; //!< of GL
    std::string version;  //!< of GL
    std::string processor;
    unsigned int numThreads = 0;
    std::string commit; //!< of this program, as git describes it
    std::string date;   //!< in UTC, as ISO 8601 has it

    /** @param context is made current. */
    static BenchEnvironment find(osg::GraphicsContext& context);

    /** Whether the renderer runs on the processor, so that GL's own clock says nothing of a GPU. */
    bool isSoftware() const;

    /** All of it as names and values. */
    std::vector<std::pair<std::string, std::string>> toFields() const;
};

} // namespace osgLego
