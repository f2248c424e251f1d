#pragma once

#include "BenchMeshes.h"

#include <osgLego/BrickAppearance.h>
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

/** A mesh in bricks, and its viewpoint. */
struct BenchScene
{
    /** A mesh at a resolution, with all other settings at their defaults. */
    BenchScene(const MeshSource& source, unsigned int resolution);

    /** Create a node with the mesh's bricks; frames wait for them. Throws std::runtime_error for an unreadable mesh. */
    osg::ref_ptr<LegoNode> createLego(BrickOcclusion occlusion = BrickAppearance().occlusion) const;
    /** Point a camera at bricks with the given bounds. */
    void placeCamera(osg::Camera& camera, const osg::BoundingSphere& bound, const glm::ivec2& size) const;

    MeshSource mesh;
    LegoSettings settings;
    double azimuth = 30.0; //!< degrees, like osglegocapture's --view
    double elevation = 25.0;
    double distance = 3.5; //!< radii of the bricks' bounding sphere
};

/** A viewer with its own context, without a display, whose camera draws into the context's own frame buffer. Throws
 * std::runtime_error if EGL provides no GL. One thread. */
class FrameViewer
{
public:
    /** @param size in pixels. */
    explicit FrameViewer(const glm::ivec2& size);

    /** Show a scene graph from the viewpoint of a scene. */
    void show(osg::Node& node, const BenchScene& scene);
    /** Draw without waiting for completion. */
    void drawFrame() { _viewer.frame(); }
    /** Draw a frame and wait for its completion.
     * @param group marks its GL commands in traces of apitrace, where scripts/bench counts them.
     * @return the duration in milliseconds. */
    double timeFrame(const char* group = "frame");
    /** The picture drawn last. */
    osg::ref_ptr<osg::Image> read() const;

    /** The durations of the traversals of a frame, in milliseconds. Drawing ends when all commands have been issued. */
    struct Traversals
    {
        double update = 0.0;
        double cull = 0.0;
        double draw = 0.0;
    };
    /** Draw a frame, wait for its completion, and return the durations that OSG has measured. */
    Traversals timeTraversals();

    osg::GraphicsContext& getContext() const { return *_context; }
    unsigned int getContextID() const { return _context->getState()->getContextID(); }

private:
    glm::ivec2 _size;
    osgViewer::Viewer _viewer; // closes the context when it is destroyed
    osg::ref_ptr<osg::GraphicsContext> _context;
};

/** Throws std::runtime_error, with the reason, if a node has no bricks in a viewer's context. */
void checkBricks(const LegoNode& lego, const FrameViewer& viewer);
/** Throws std::runtime_error if all pixels of a picture of bricks are equal, such as when a shader failed to compile.
 */
void checkPicture(const osg::Image& picture);

} // namespace osgLego
