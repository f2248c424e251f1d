#pragma once

#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/PictureTiles.h>
#include <osgLego/store/BrickStore.h>

#include <osg/State>
#include <osg/StateSet>
#include <osg/buffered_value>
#include <osg/ref_ptr>

namespace osgLego
{

class SplatTarget;

/** Draws bricks without triangles, for renderers in software, to which small triangles are dear: as points, whose
 * pixels find by their rays which brick they show; each pixel is then shaded once.
 *
 * The picture is the one that the geometry shader makes, in depth and colour, of bricks behind the near plane and in a
 * state that shows nothing but the nearest surface.
 */
class BrickSplats
{
public:
    /** @param shading the state of the last pass: a program of splat_shading.vert and of fragments that SPLATS is
     * defined for.
     * @param shadingByOneLight the same where the scene has one light: that ONE_LIGHT is defined for, too. */
    BrickSplats(osg::StateSet& shading, osg::StateSet& shadingByOneLight);
    ~BrickSplats();

    /** Draw; leaves a state set of this class applied. Needs the context of the state current.
     * @param drawing SPLATS: on any renderer; AUTO: only on one in software.
     * @return false, and nothing is drawn, when the renderer does not want splats, or the bricks or the frame buffer
     * that is bound are not for this way. */
    bool draw(osg::State& state, const ContextBricks& bricks, const BrickRanges& ranges, const CellView& view,
              Drawing drawing) const;

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    /** Find what each pixel of a target shows; false when a program or the target can't be had. */
    bool drawPoints(osg::State& state, SplatTarget& target, const ContextBricks& bricks, const BrickRanges& ranges,
                    const CellView& view, const CellView::Rays& rays, const glm::ivec2& size) const;

    /** Draw a point for each tile of the picture that bricks may lie in, by the program that is applied. */
    void drawTiles(const osg::State& state, const ContextBricks& bricks, const BrickRanges& ranges,
                   const CellView& view, const glm::ivec2& size) const;

    osg::ref_ptr<osg::StateSet> _boxes;   // bricks whose studs, if any, are not seen
    osg::ref_ptr<osg::StateSet> _studded; // the others
    osg::ref_ptr<osg::StateSet> _shading;
    osg::ref_ptr<osg::StateSet> _shadingByOneLight;
    mutable osg::buffered_object<osg::ref_ptr<SplatTarget>> _targets; // one for all in a context
    mutable osg::buffered_object<PictureTiles> _tiles;
};

} // namespace osgLego
