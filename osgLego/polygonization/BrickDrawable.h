#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/gl/SharedGlObjects.h>
#include <osgLego/polygonization/BrickLight.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/BrickSplats.h>
#include <osgLego/polygonization/BrickStates.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/CoreClipPlanes.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/store/BrickStore.h>

#include <cstddef>

#include <osg/Drawable>
#include <osg/buffered_value>

namespace osgLego
{

/** Draws the bricks of a context: as points that a geometry shader turns into faces and studs (the paper, section
 * III-C, Algorithm 5) or, by default, as splats (BrickSplats).
 *
 * Sets the uniforms of the scene's lights and fog in the programs of BrickStates; with GL_LIGHTING off, colours are
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
        bool isPartial = false;        //!< whether the programs draw the model partly built (BrickStore::getBuilding())
        double outline = 0.0;          //!< see BrickAppearance
        bool hasGridOcclusion = false; //!< whether the programs use grid occlusion
        bool hasDistantOcclusion = false; //!< whether the programs use distant occlusion
        int occluder = 0; //!< the number of the node in a geometry buffer (geometry_buffer.glsl), 1 to 255; 0: none
    };

    BrickDrawable(const Options& options, const BrickStates& states);

    /** Called in the cull traversal before it is drawn in a context. */
    void useIn(unsigned int contextID) const { SharedGlObjects::get().addUser(contextID, this); }

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
    ~BrickDrawable() override;

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
        osg::ref_ptr<const PartHighlight> highlight;
    };

    /** Null: none. */
    struct Occlusion
    {
        const GridOcclusionTextures* near = nullptr;
        DistantOcclusionTexture* distant = nullptr;
    };

    Shown getShown() const;
    bool prepare(const osg::State& state, ContextBricks& bricks, const Shown& shown) const;
    osg::Matrixd getCellsToEye(const ContextBricks& bricks, const osg::Matrixd& modelView) const;
    DrawnBricks getDrawn(const osg::State& state, const ContextBricks& bricks, const Shown& shown,
                         const osg::Matrixd& cellsToEye) const;
    NearOcclusion getNearOcclusion() const;
    Occlusion findOcclusion(const osg::State& state, ContextBricks& bricks) const;
    BrickLight findLight(osg::RenderInfo& renderInfo, ContextBricks& bricks, const DrawnBricks& drawn,
                         const osg::Matrixd& modelView) const;
    SplatJob* findSplats(osg::RenderInfo& renderInfo, const SplatDestination& destination) const;
    void addSplats(const osg::State& state, const SplatDestination& destination, const osg::Matrixd& modelView) const;
    void addFollowing(osg::RenderInfo& renderInfo, const SplatDestination& destination) const;
    bool drawPoints(osg::State& state, const SplatDestination& destination, std::size_t first) const;
    bool drawSplats(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                    const SplatJob& job, const BrickLight& light) const;
    void drawColors(osg::RenderInfo& renderInfo, const SplatDestination& destination, ContextBricks& bricks,
                    const DrawnBricks& drawn, const SplatJob* job, const osg::Matrixd& modelView) const;
    void drawDepths(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                    Workspace& workspace, const CoreClipPlanes& clipPlanes) const;
    void drawTriangles(osg::State& state, const DrawnBricks& bricks, Workspace& workspace, const BrickLight& light,
                       const CoreClipPlanes& clipPlanes) const;

    osg::ref_ptr<BrickStore> _store;
    Drawing _drawing;
    bool _isPartial;
    double _outline;
    bool _hasGridOcclusion;
    int _occluder;
    /** Shown until there is distant occlusion; null if the programs don't use it. */
    osg::ref_ptr<DistantOcclusionTexture> _noOcclusion;
    osg::ref_ptr<const BrickStates> _states;
    mutable osg::buffered_object<Workspace> _workspaces;
    BrickSplats _splats;
};

} // namespace osgLego
