#pragma once

#include <osgLego/BrickStore.h>

#include <osg/Drawable>

namespace osgLego
{

/** Draws the bricks of a context, each a point that a geometry shader makes faces and a stud of (the paper, section
 * III-C, Algorithm 5).
 *
 * Tells the program of BrickNodes, under which it is drawn, of the scene's lights and fog; with GL_LIGHTING off,
 * colours show as they are. Draws nothing in a context in which no bricks are made yet. Not an osg::Geometry, since the
 * optimizer merges those.
 */
class BrickDrawable : public osg::Drawable
{
public:
    explicit BrickDrawable(BrickStore& store);

    osg::BoundingBox computeBoundingBox() const override;
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

    // For picking: the open faces of the bricks, from the CPU.
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    void accept(osg::PrimitiveFunctor& functor) const override;
    using osg::Drawable::accept;
    using osg::Drawable::supports;

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickDrawable*>(object) != nullptr;
    }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "BrickDrawable"; }

private:
    ~BrickDrawable() override = default;

    osg::ref_ptr<BrickStore> _store;
};

} // namespace osgLego
