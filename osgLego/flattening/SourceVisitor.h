#pragma once

#include <cstddef>
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

/** Traverses the visible parts of a subgraph, and calls applySurface() for each drawable with its transform and state
 * sets.
 *
 * It visits the children of a Switch that are on, the most detailed loaded children of an LOD, and the current child of
 * a Sequence or, before the first update, the one that it will begin with. It skips cameras that draw before or after
 * the scene or into a texture, and osgText::Text, whose letters are only in the alpha channel of a texture. Changes
 * nothing in the subgraph; one thread at a time.
 */
class SourceVisitor : public osg::NodeVisitor
{
public:
    META_NodeVisitor(osgLego, SourceVisitor)

    SourceVisitor();
    /** @param toRoot the transform from the coordinates of the node that accepts the visitor to those of
     * applySurface().
     */
    explicit SourceVisitor(const osg::Matrixd& toRoot);

    void apply(osg::Node& node) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Camera& camera) override;
    void apply(osg::LOD& lod) override;
    void apply(osg::Sequence& sequence) override;
    void apply(osg::Drawable& drawable) override;

    /** The number of texts that were skipped. */
    std::size_t getNumTexts() const { return _numTexts; }

protected:
    /** Called for each visible drawable.
     * @param toRoot the transform from its coordinates to those of the node that accepted the visitor, or to the root's
     * if the constructor was given one.
     * @param stateSets the state sets that apply to it, outermost first, its own last. */
    virtual void applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                              const std::vector<const osg::StateSet*>& stateSets) = 0;

private:
    void traverseWithState(osg::Node& node);
    bool pushState(const osg::Node& node);

    osg::Matrixd _matrix;
    std::size_t _numTexts = 0;
    std::vector<const osg::StateSet*> _stateSets;
};

} // namespace osgLego
