#pragma once

#include "BookletCamera.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/LegoNode.h>

#include <cstddef>

#include <glm/vec2.hpp>
#include <osg/Camera>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Vec4>
#include <osg/ref_ptr>
#include <osgViewer/Viewer>

namespace osgLego
{

/** Draws models of parts in a context: all pictures of a booklet share its GL objects.
 *
 * Throws CaptureError if the context can't draw bricks. One thread.
 */
class BookletRenderer
{
public:
    explicit BookletRenderer(osg::GraphicsContext& context);

    /** Show a model. @param plan the order of its parts, for setPlaced(). */
    void setModel(const BrickModel& model, const BuildingPlan& plan);
    /** Show the first parts in the order of building, and highlight the last of them. */
    void setPlaced(std::size_t numPlaced, std::size_t numNew);

    /** Light the model from above, or from below if it lies on its studs. Call it after setModel(). */
    void setUpsideDown(bool isUpsideDown);
    /** Set whether pictures have ambient occlusion, which takes two thirds of the time. */
    void setOcclusion(bool hasOcclusion);

    /** Draw the model over white.
     * @param size in pixels.
     * @return 8-bit RGB, bottom row first. */
    osg::ref_ptr<osg::Image> draw(const BookletCamera& place, const BookletFrame& frame, const glm::ivec2& size);
    /** Likewise over a transparent background. @return 8-bit RGBA with straight alpha. */
    osg::ref_ptr<osg::Image> drawTransparent(const BookletCamera& place, const BookletFrame& frame,
                                             const glm::ivec2& size);

private:
    osg::ref_ptr<osg::Image> drawOver(const osg::Vec4& background, const glm::ivec2& size);
    void addLight();
    void checkSupport(osg::GraphicsContext& context) const;

    osgViewer::Viewer _viewer; // closes the context on destruction
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<const BrickModel> _model;
};

} // namespace osgLego
