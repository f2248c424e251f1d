#include "FrameViewer.h"

#include "BenchView.h"

#include <offscreen/OffscreenContext.h>

#include <stdexcept>
#include <string>

#include <osg/PolygonOffset>

namespace osgLego
{

void drawByTriangles(osg::Node& node)
{
    // Geometry that is offset is, as rays know nothing of slopes; this offset moves nothing.
    node.getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(0.0f, 0.0f));
}

FrameViewer::FrameViewer(const glm::ivec2& size) : _size(size)
{
    std::string error;
    _context = createOffscreenContext(size.x, size.y, error);
    if (!_context) throw std::runtime_error(error);
    osg::Camera& camera = *_viewer.getCamera();
    camera.setGraphicsContext(_context);
    camera.setViewport(0, 0, size.x, size.y);
    camera.setDrawBuffer(GL_BACK);
    camera.setReadBuffer(GL_BACK);
    camera.setClearColor(osg::Vec4(0.0f, 0.0f, 0.2f, 1.0f));
    camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
}

void FrameViewer::show(osg::Node& node, const BenchScene& scene)
{
    _viewer.setSceneData(&node);
    placeCamera(*_viewer.getCamera(), scene, node.getBound(), static_cast<double>(_size.x) / _size.y);
}

osg::ref_ptr<osg::Image> FrameViewer::read() const
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->readPixels(0, 0, _size.x, _size.y, GL_RGB, GL_UNSIGNED_BYTE);
    return image;
}

} // namespace osgLego
