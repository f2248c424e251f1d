#pragma once

#include <osgLego/polygonization/BrickLight.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/BrickStates.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/polygonization/PictureTiles.h>
#include <osgLego/polygonization/SplatTarget.h>

#include <vector>

#include <glm/vec2.hpp>
#include <osg/State>
#include <osg/StateSet>
#include <osg/buffered_value>
#include <osg/ref_ptr>

namespace osgLego
{

/** Apply a state set, and the matrix uniforms that OSG can set instead of the built-in matrices.
 * @return whether its program could be applied. */
bool applyBrickState(osg::State& state, const osg::StateSet& stateSet);

/** What to draw into a depth buffer without colours. */
struct DepthJob
{
    const CellView& view;
    Faces faces;
    const BrickRanges& ranges; //!< with these faces
};

/** Draws bricks as points instead of triangles, since small triangles are expensive on all renderers that were
 * measured: each pixel of a point intersects its ray with the brick; then each pixel of the picture is shaded once.
 *
 * Depth and colour are the same as with the geometry shader, provided that the bricks are behind the near plane and the
 * state shows only the nearest surface. All functions for drawing need the context of the state current.
 */
class BrickSplats
{
public:
    explicit BrickSplats(const BrickStates& states);
    ~BrickSplats();

    /** The target of the current context, which is kept until releaseGLObjects(). */
    SplatTarget& getTarget(const osg::State& state) const;

    /** Complete a job, whose view and ranges are set.
     * @return whether splats can draw the bricks into the destination. */
    bool prepare(const osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                 SplatJob& job) const;
    /** Whether a job has points of bricks with or without visible studs. */
    static bool hasPoints(const DrawnBricks& bricks, const SplatJob& job, bool hasStuds);
    /** Draw these points into the target, with the applied program. @param size of the picture, in pixels. */
    static void drawPoints(osg::State& state, const DrawnBricks& bricks, const SplatJob& job, bool hasStuds,
                           const glm::ivec2& size);
    /** Shade the pixels of a job whose points have been drawn. Leaves the state for shading applied.
     * @return false, with nothing drawn, if its program can't be applied. */
    bool shade(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks, const SplatJob& job,
               const BrickLight& light) const;

    /** Draw the depths of bricks right into a destination.
     * @return false, with nothing drawn or only a part of it, if that is impossible. */
    bool drawDepths(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                    const DepthJob& job) const;

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    bool findRays(const osg::State& state, const SplatDestination& destination, const CellView& view,
                  CellView::Rays& rays) const;
    /** Draw a point for each tile of the picture that may contain bricks, with the applied program. */
    void drawTiles(const osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges, const CellView& view,
                   const glm::ivec2& size) const;

    osg::ref_ptr<const BrickStates> _states;
    mutable osg::buffered_object<std::vector<osg::ref_ptr<SplatTarget>>> _targets; // of contexts with the same ID
    mutable osg::buffered_object<PictureTiles> _tiles;
};

} // namespace osgLego
