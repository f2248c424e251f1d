#pragma once

#include "BenchScene.h"

#include <common/JsonValue.h>

#include <glm/vec2.hpp>

namespace osgLego
{

/** What to draw with many nodes. */
struct NodesOptions
{
    unsigned int numNodes = 200;
    unsigned int numFrames = 20;
    bool hasOcclusion = false;
    glm::ivec2 size{1280, 720}; //!< of the picture, in pixels
};

/** Compare many nodes, which share a mesh as their source, with one such node, and with one node that has the mesh in
 * as many places and so the same bricks in all. Each is measured in a separate process; see measureInSeparateProcess()
 * for what the calling process must not have.
 * @param scene the mesh and the settings of each node; its resolution gives the size of cells.
 * @return rows of figures, and their goals. Throws std::runtime_error. */
JsonValue compareNodes(const BenchScene& scene, const NodesOptions& options);

/** Print the rows and goals as tables. */
void printNodes(const JsonValue& document);

} // namespace osgLego
