#pragma once

#include "BenchMeshes.h"

#include <osgLego/LegoNode.h>

#include <string>

#include <glm/vec2.hpp>
#include <osg/BoundingSphere>
#include <osg/Camera>
#include <osg/Image>
#include <osg/ref_ptr>
#include <osgViewer/Viewer>

namespace osgLego
{

/** A mesh in bricks, and the point that it is viewed from. */
struct BenchScene
{
    /** A mesh at a resolution, with default settings otherwise. */
    BenchScene(const MeshSource& source, unsigned int resolution);

    /** The bricks of the mesh, which frames wait for. Throws std::runtime_error when it can't be read. */
    osg::ref_ptr<LegoNode> createLego() const;
    /** Let a camera look at bricks of some bounds. */
    void placeCamera(osg::Camera& camera, const osg::BoundingSphere& bound, const glm::ivec2& size) const;

    MeshSource mesh;
    LegoSettings settings;
    double azimuth = 30.0; //!< degrees, as of osglegocapture's --view
    double elevation = 25.0;
    double distance = 3.5; //!< radii of the bricks' bounding sphere
};

/** A viewer of a context of its own, without a display, whose camera draws into the context's own frame buffer. Throws
 * std::runtime_error when there is no GL by EGL. One thread. */
class FrameViewer
{
public:
    /** @param size in pixels. */
    explicit FrameViewer(const glm::ivec2& size);

    /** Show a scene graph, its bounding sphere seen as a scene says. */
    void show(osg::Node& node, const BenchScene& scene);
    /** Draw, without waiting until that is done. */
    void drawFrame() { _viewer.frame(); }
    /** @param group marks its GL commands in traces of apitrace, in which scripts/bench counts.
     * @return milliseconds of a frame, the last command finished. */
    double timeFrame(const char* group = "frame");
    /** The picture drawn last. */
    osg::ref_ptr<osg::Image> read() const;

    osg::GraphicsContext& getContext() const { return *_context; }
    unsigned int getContextID() const { return _context->getState()->getContextID(); }

private:
    glm::ivec2 _size;
    osgViewer::Viewer _viewer; // closes the context when it is destroyed
    osg::ref_ptr<osg::GraphicsContext> _context;
};

/** Throws std::runtime_error, with the reason, unless a node has its bricks in a viewer's context. */
void checkBricks(const LegoNode& lego, const FrameViewer& viewer);

} // namespace osgLego
