#pragma once

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** The sources of nodes whose memory is measured. Stored bricks and meshes are five bricks, in other colours for each
 * node, so that nodes share nothing by equal bricks. */
enum class SmallSource
{
    STORED, //!< stored bricks, read from a file in memory
    MESH,   //!< a box of its own
    SAMPLE  //!< the racing car, read by the pseudo-loader
};

/** Measure the memory of many small nodes: after they have been made, and after all have been drawn in one viewer.
 * Measured in a separate process; see measureInSeparateProcess() for what the calling process must not have.
 * @param picture the file for a picture of the nodes; empty: none.
 * @return figures with goals. Throws std::runtime_error, also if a node is not drawn. */
JsonValue measureNodesMemory(SmallSource source, unsigned int numNodes, const std::string& picture);

/** Print the figures and the goals of a document's rows as tables. */
void printNodesMemory(const JsonValue& document);

} // namespace osgLego
