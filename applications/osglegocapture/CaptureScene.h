#pragma once

#include "CaptureOptions.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <osg/Camera>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Node>
#include <osgViewer/Viewer>

namespace osgLego
{

/** What is captured: a mesh, the bricks of it, and the camera in front of them.
 *
 * Throws CaptureError. One thread.
 */
class CaptureScene
{
public:
    /** Read the mesh, or make the built-in one. */
    explicit CaptureScene(const CaptureOptions& options);

    /** Take a node, which may hold LegoNodes and AmbientOcclusionScenes of its own, in place of a mesh. */
    CaptureScene(const CaptureOptions& options, const osg::ref_ptr<osg::Node>& node);

    /** Draw in a context, as often as it takes for the bricks to be there.
     * @return the picture, its first row at the bottom: RGB of 8 bits, or, with a transparent background, RGBA, its
     * colours not multiplied by alpha. */
    osg::ref_ptr<osg::Image> draw(osg::GraphicsContext& context);

    /** About how much memory draw() takes for the pixels of the picture, most of it in buffers of GL, in bytes. */
    double estimateMemory() const;

    /** The node that makes the bricks; null when the mesh is drawn as it is. */
    LegoNode* getLegoNode() const { return _lego.get(); }
    /** The node that adds ambient occlusion; null without. */
    AmbientOcclusionScene* getOcclusionScene() const { return _occlusion.get(); }
    double getReadingTime() const { return _readingTime; }
    /** Milliseconds of the last frame in which nothing was made anew. */
    double getDrawingTime() const { return _drawingTime; }

private:
    void prepare();
    void unwrapSource();
    void legolize();
    void addOcclusion();
    void setOcclusion();
    void setProbe(const LightProbe& probe);
    osg::ref_ptr<LightProbe> createProbe() const;
    void checkSupport(osg::GraphicsContext& context) const;
    void checkLegolized(const osg::State& state) const;
    void setUpCamera(osg::GraphicsContext& context, osg::Image& image);
    void placeCamera(osg::Camera& camera) const;
    void timeFrame(osg::GraphicsContext& context);
    osg::ref_ptr<osg::Image> drawTransparent(const osg::Image& image);
    LegoSettings getSettings() const;

    const CaptureOptions& _options;
    osgViewer::Viewer _viewer; // closes the context when it goes
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osg::Node> _source;
    LegoSettings _sourceSettings; // those of a node that a pseudo-loader had put around the mesh
    osg::ref_ptr<osg::Node> _shown;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    bool _isRead = false;       // the source is from a file,
    bool _hasOwnBricks = false; // and is in bricks there
    double _readingTime = 0.0;
    double _drawingTime = 0.0;
};

} // namespace osgLego
