#pragma once

#include "OcclusionBench.h"

#include <glm/vec2.hpp>
#include <osg/GraphicsContext>
#include <osg/Group>
#include <osg/Image>
#include <osgViewer/Viewer>

namespace osgLego
{

/** Have bricks drawn by triangles where splats would be drawn. */
void drawByTriangles(osg::Node& node);

/** A viewer of a context without a display, as a program has one: its camera draws into the context's own frame
 * buffer. Throws std::runtime_error when there is no GL by EGL. One thread. */
class FrameViewer
{
public:
    explicit FrameViewer(const glm::ivec2& size);

    /** Show a scene, its bounding sphere from where a scene of the bench is looked at. */
    void show(osg::Node& node, const BenchScene& scene);
    void drawFrame() { _viewer.frame(); }
    /** What was drawn last. */
    osg::ref_ptr<osg::Image> read() const;

    osg::GraphicsContext& getContext() const { return *_context; }
    unsigned int getContextID() const { return _context->getState()->getContextID(); }

private:
    glm::ivec2 _size;
    osgViewer::Viewer _viewer; // closes the context when it goes
    osg::ref_ptr<osg::GraphicsContext> _context;
};

} // namespace osgLego
