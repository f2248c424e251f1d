#pragma once

#include "BookletCamera.h"

#include <common/PictureRenderer.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/LegoNode.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>
#include <osg/GraphicsContext>
#include <osg/Image>
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

    /** Show another model below, such as a base plate. @param base null for none. */
    void setBase(const BrickModel* base);
    /** Set whether pictures have ambient occlusion, which takes two thirds of the time. */
    void setOcclusion(bool hasOcclusion);

    /** Draw the model over white.
     * @param size in pixels.
     * @return 8-bit RGB, bottom row first. */
    osg::ref_ptr<osg::Image> draw(const BookletCamera& camera, const BookletFrame& frame, const glm::ivec2& size);
    /** Likewise with the new parts in one colour. Call it after draw(), which shows the model. */
    osg::ref_ptr<osg::Image> drawNewParts(const BookletCamera& camera, const BookletFrame& frame,
                                          const glm::ivec2& size, const std::array<std::uint8_t, 3>& color);
    /** Likewise over a transparent background. @return 8-bit RGBA with straight alpha. */
    osg::ref_ptr<osg::Image> drawTransparent(const BookletCamera& camera, const BookletFrame& frame,
                                             const glm::ivec2& size);

private:
    void place(const BookletCamera& camera, const BookletFrame& frame);

    PictureRenderer _renderer;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<LegoNode> _base;
    osg::ref_ptr<const BrickModel> _model;
    osg::ref_ptr<const BuildingPlan> _plan;
    std::size_t _numPlaced = 0;
    std::size_t _numNew = 0;
};

} // namespace osgLego
