#pragma once

#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/polygonization/PictureTiles.h>

#include <osg/State>
#include <osg/StateSet>
#include <osg/buffered_value>
#include <osg/ref_ptr>

namespace osgLego
{

class SplatTarget;

/** Draws bricks as points instead of triangles, for software renderers, on which small triangles are expensive: each
 * pixel of a point intersects its ray with the brick; then each pixel of the picture is shaded once.
 *
 * Depth and colour are the same as with the geometry shader, provided that the bricks are behind the near plane and the
 * state shows only the nearest surface.
 */
class BrickSplats
{
public:
    /** @param shading the state of the last pass: its program has splat_shading.vert and a fragment shader with SPLATS
     * defined.
     * @param shadingByOneLight likewise for scenes with one light: ONE_LIGHT is defined, too.
     * @param isPartial whether the model is drawn partly built: PARTIAL is defined, too. */
    BrickSplats(osg::StateSet& shading, osg::StateSet& shadingByOneLight, bool isPartial);
    ~BrickSplats();

    /** Draw the bricks. Leaves a state set of this class applied. Needs the context of `state` current.
     * @param distant the distant occlusion for the shading state; null if it uses none.
     * @param drawing SPLATS: on any renderer; AUTO: only on software renderers.
     * @return false, with nothing drawn, if splats are not to be used on this renderer, or can't draw these bricks or
     * into the bound frame buffer. */
    bool draw(osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges, const CellView& view,
              Drawing drawing, const DistantOcclusionView* distant) const;

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    /** Find the brick that each pixel of a target shows. Returns false if a program or the target can't be created. */
    bool drawPoints(osg::State& state, SplatTarget& target, const DrawnBricks& bricks, const BrickRanges& ranges,
                    const CellView& view, const CellView::Rays& rays, const glm::ivec2& size) const;

    /** Draw a point for each tile of the picture that may contain bricks, with the applied program. */
    void drawTiles(const osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges, const CellView& view,
                   const glm::ivec2& size) const;

    osg::ref_ptr<osg::StateSet> _boxes;   // for bricks without visible studs
    osg::ref_ptr<osg::StateSet> _studded; // for the other bricks
    osg::ref_ptr<osg::StateSet> _shading;
    osg::ref_ptr<osg::StateSet> _shadingByOneLight;
    mutable osg::buffered_object<osg::ref_ptr<SplatTarget>> _targets; // shared by all nodes in a context
    mutable osg::buffered_object<PictureTiles> _tiles;
};

} // namespace osgLego
