#pragma once

#include <osgLego/Export.h>

#include <cstdint>

#include <osg/Node>

namespace osgLego
{

/** A number that changes whenever what a subgraph shows does.
 *
 * Takes in transforms, switches, levels of detail, materials, textures and their images, and the arrays and primitive
 * sets of geometries: by their modified counts (`array->dirty()`), and, where a geometry's data variance is DYNAMIC, by
 * their contents. So a change of any of them is found without a word to the LegoNode, and a frame that changes nothing
 * costs a walk over the nodes, not over the triangles.
 *
 * May be called from any thread as long as no other thread changes the subgraph. */
OSGLEGO_EXPORT std::uint64_t computeSourceSignature(const osg::Node& node);

} // namespace osgLego
