#pragma once

#include "BookletCamera.h"

#include <common/PictureRenderer.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/LegoNode.h>

#include <cstddef>

#include <glm/vec2.hpp>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Draws models of parts in a context: all pictures of a booklet share its GL objects.
 *
 * One thread.
 */
class BookletRenderer
{
public:
    /** @param context that can draw bricks; it must not be current. */
    explicit BookletRenderer(osg::GraphicsContext& context);

    /** Show a model. @param plan the order of its parts, for setPlaced(). */
    void setModel(const BrickModel& model, const BuildingPlan& plan);
    /** Show the first parts in the order of building, and highlight the last of them. */
    void setPlaced(std::size_t numPlaced, std::size_t numNew);

    /** Show another model below, such as a base plate, and something on the table, such as a grid; null for none. */
    void setBase(const BrickModel* base, osg::Node* table = nullptr);
    /** Set whether bricks look like plastic in the light of the sky, or drawn with lines as in building instructions,
     * as at first. */
    void setFullLook(bool isFull);

    /** Draw the model over white.
     * @param size in pixels.
     * @throws BookletFailure if bricks can't be drawn, such as without memory of GL, as drawTransparent() does.
     * @return 8-bit RGB, bottom row first. */
    osg::ref_ptr<osg::Image> draw(const BookletCamera& camera, const BookletFrame& frame, const glm::ivec2& size);
    /** Likewise over a transparent background. @return 8-bit RGBA with straight alpha. */
    osg::ref_ptr<osg::Image> drawTransparent(const BookletCamera& camera, const BookletFrame& frame,
                                             const glm::ivec2& size);

private:
    void place(const BookletCamera& camera, const BookletFrame& frame);
    void checkDrawn() const;

    osg::ref_ptr<osg::GraphicsContext> _context;
    PictureRenderer _renderer;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<LegoNode> _base;
    osg::ref_ptr<osg::Node> _table;
    osg::ref_ptr<const BrickModel> _model;
};

} // namespace osgLego
