#pragma once

#include <vector>

#include <osg/Camera>
#include <osg/Drawable>
#include <osg/LOD>
#include <osg/Matrixd>
#include <osg/NodeVisitor>
#include <osg/Sequence>
#include <osg/StateSet>
#include <osg/Transform>

namespace osgLego
{

/** Walks over what of a subgraph would be shown, and hands on each drawable with its transform and state sets.
 *
 * Of a Switch the children that are on, of an LOD the most detailed ones that are there, of a Sequence the one that is
 * its turn, or, before the first update, will be; cameras that draw elsewhere (before, after, to a texture) are passed
 * over. Reads only; one thread at a time.
 */
class SourceVisitor : public osg::NodeVisitor
{
public:
    META_NodeVisitor(osgLego, SourceVisitor)

    SourceVisitor();

    void apply(osg::Node& node) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Camera& camera) override;
    void apply(osg::LOD& lod) override;
    void apply(osg::Sequence& sequence) override;
    void apply(osg::Drawable& drawable) override;

protected:
    /** A drawable that would be shown. @param toRoot from its coordinates to those of the node first visited;
     * @param stateSets the ones above it, outermost first, its own last. */
    virtual void applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                              const std::vector<const osg::StateSet*>& stateSets) = 0;

private:
    void traverseWithState(osg::Node& node);
    bool pushState(const osg::Node& node);

    osg::Matrixd _matrix;
    std::vector<const osg::StateSet*> _stateSets;
};

} // namespace osgLego
