#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <osg/Node>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

class SourceVisitor;

/** A hash of the visible contents of a subgraph, and the objects whose addresses went into it. These are referenced so
 * that no new object gets the address of an old one. */
struct SourceSignature
{
    std::uint64_t value = 0;
    std::vector<osg::ref_ptr<const osg::Referenced>> objects;

    bool operator==(const SourceSignature& other) const { return value == other.value; }
};

/** Compute a signature that changes with the visible contents of a subgraph.
 *
 * It covers transforms, switches, levels of detail, materials, textures and their images, and the arrays and primitive
 * sets of geometries: by their modified counts (`array->dirty()`), and also by their contents if the geometry's data
 * variance is DYNAMIC. So LegoNode detects these changes by itself, and a frame without changes costs a traversal of
 * the nodes, not of the triangles.
 *
 * May be called from any thread as long as no other thread changes the subgraph. */
SourceSignature computeSourceSignature(const osg::Node& node);

/** Hash the arrays and primitive sets of all geometries below a node by their contents, including changes without
 * dirty(). Takes the time of reading them. May be called from any thread as long as no other thread changes the
 * subgraph. */
std::uint64_t hashSourceContents(const osg::Node& node);

/** Computes signatures repeatedly, without allocating memory for each. One thread at a time. */
class SourceSignatures
{
public:
    SourceSignatures();
    ~SourceSignatures();

    /** @return a signature that is valid until the next call. */
    const SourceSignature& compute(const osg::Node& node);

private:
    std::unique_ptr<SourceVisitor> _visitor;
};

} // namespace osgLego
