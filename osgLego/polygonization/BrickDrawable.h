#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/BrickSplats.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/store/BrickStore.h>

#include <osg/Drawable>
#include <osg/StateSet>
#include <osg/buffered_value>

namespace osgLego
{

/** Draws the bricks of a context: as points that a geometry shader turns into faces and studs (the paper, section
 * III-C, Algorithm 5) or, on software renderers, as splats (BrickSplats).
 *
 * Sets the uniforms of the scene's lights and fog in the programs of BrickNodes; with GL_LIGHTING off, colours are
 * drawn unchanged. Draws nothing in a context that has no bricks yet. It is not an osg::Geometry, since the optimizer
 * merges those.
 */
class BrickDrawable : public osg::Drawable
{
public:
    struct Options
    {
        BrickStore* store = nullptr;
        Drawing drawing = Drawing::AUTO;
        bool isPartial = false; //!< whether the programs draw the model partly built (BrickStore::getBuilding())
        double outline = 0.0;   //!< see BrickAppearance
        bool hasDistantOcclusion = false; //!< whether the programs use distant occlusion
    };

    /** @param geometryState the state for drawing with the geometry shader, including its program.
     * @param splatState the state for drawing splats, with the program that shades them.
     * @param splatStateByOneLight likewise, for scenes with one light. */
    BrickDrawable(const Options& options, osg::StateSet& geometryState, osg::StateSet& splatState,
                  osg::StateSet& splatStateByOneLight);

    osg::BoundingBox computeBoundingBox() const override;
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

    /** The model that is shown, of all parts; null if there is none. */
    osg::ref_ptr<const BrickModel> getModel() const;
    /** The model of the parts in place, which accept() visits; null if there is none. */
    osg::ref_ptr<const BrickModel> getPlacedModel() const;

    // For picking; see acceptBrickTriangles.
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    void accept(osg::PrimitiveFunctor& functor) const override;
    using osg::Drawable::accept;
    using osg::Drawable::supports;

    osg::Object* cloneType() const override { return nullptr; }
    /** Itself: visitors that copy subgraphs, such as those of osgUtil::Optimizer, reach it below a LegoNode, whose copy
     * has a drawable of its own. */
    osg::Object* clone(const osg::CopyOp&) const override { return const_cast<BrickDrawable*>(this); }
    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickDrawable*>(object) != nullptr;
    }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "BrickDrawable"; }

private:
    ~BrickDrawable() override = default;

    /** Memory that is reused by all frames of a context. */
    struct Workspace
    {
        osg::ref_ptr<osg::RefMatrix> cellsToEye;
        BrickRanges ranges;
    };

    /** The contents of the store in one frame. */
    struct Shown
    {
        osg::ref_ptr<const BrickSet> bricks;
        osg::ref_ptr<const BuildingSet> building;
        BuildingState state;
    };

    bool prepare(const osg::State& state, ContextBricks& bricks, const Shown& shown) const;
    void drawBricks(osg::State& state, const DrawnBricks& bricks, Workspace& workspace,
                    const DistantOcclusionView* distant) const;

    osg::ref_ptr<BrickStore> _store;
    Drawing _drawing;
    bool _isPartial;
    double _outline;
    /** Shown until there is distant occlusion; null if the programs don't use it. */
    osg::ref_ptr<DistantOcclusionTexture> _noOcclusion;
    osg::ref_ptr<osg::StateSet> _geometryState;
    mutable osg::buffered_object<Workspace> _workspaces;
    BrickSplats _splats;
};

} // namespace osgLego
