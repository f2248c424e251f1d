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

/** What tells whether a subgraph shows what it did: a number, and the objects that it came from, which are held so that
 * no new one comes to lie where an old one lay. */
struct SourceSignature
{
    std::uint64_t value = 0;
    std::vector<osg::ref_ptr<const osg::Referenced>> objects;

    bool operator==(const SourceSignature& other) const { return value == other.value; }
};

/** A signature that changes whenever what a subgraph shows does.
 *
 * Takes in transforms, switches, levels of detail, materials, textures and their images, and the arrays and primitive
 * sets of geometries: by their modified counts (`array->dirty()`), and, where a geometry's data variance is DYNAMIC, by
 * their contents. So a change of any of them is found without a word to the LegoNode, and a frame that changes nothing
 * costs a walk over the nodes, not over the triangles.
 *
 * May be called from any thread as long as no other thread changes the subgraph. */
SourceSignature computeSourceSignature(const osg::Node& node);

/** Computes signatures time and again, without allocating memory for each. One thread at a time. */
class SourceSignatures
{
public:
    SourceSignatures();
    ~SourceSignatures();

    /** @return what lasts until the next call. */
    const SourceSignature& compute(const osg::Node& node);

private:
    std::unique_ptr<SourceVisitor> _visitor;
};

} // namespace osgLego
