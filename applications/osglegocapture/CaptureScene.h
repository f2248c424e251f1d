#pragma once

#include "CaptureOptions.h"

#include <common/PartsList.h>
#include <common/PictureRenderer.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <optional>
#include <vector>

#include <osg/Camera>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Node>

namespace osgLego
{

/** The captured scene: a mesh, its bricks, and the camera.
 *
 * Throws CaptureError. One thread.
 */
class CaptureScene
{
public:
    /** Read the mesh, or create the built-in one. */
    explicit CaptureScene(const CaptureOptions& options);

    /** Use a node instead of a mesh; it may contain LegoNodes and AmbientOcclusionScenes. */
    CaptureScene(const CaptureOptions& options, const osg::ref_ptr<osg::Node>& node);

    /** Draw in a context, repeatedly until the bricks exist.
     * @return the picture, bottom row first: 8-bit RGB or, with a transparent background, RGBA with straight alpha. */
    osg::ref_ptr<osg::Image> draw(osg::GraphicsContext& context);

    /** The approximate memory that draw() needs for the pixels of the picture, mostly in GL buffers, in bytes. */
    double estimateMemory() const;

    /** The node that makes the bricks; null if the original mesh is drawn. */
    LegoNode* getLegoNode() const { return _lego.get(); }
    /** The only node that makes bricks, for a booklet. Throws CaptureError if there are others. */
    LegoNode& getOnlyLegoNode() const;
    /** Make the bricks that do not exist yet, which may take long. */
    void makeBricks() const;
    /** The parts of all bricks in the scene. Throws CaptureError if there are none. */
    PartsList createPartsList() const;
    /** The models of the scene that have parts. Throws CaptureError if there are none. */
    std::vector<osg::ref_ptr<const BrickModel>> findPartModels() const;
    /** The node that adds ambient occlusion; null without ambient occlusion. */
    AmbientOcclusionScene* getOcclusionScene() const { return _occlusion.get(); }
    double getReadingTime() const { return _readingTime; }
    /** The time of the last frame without legolization, in milliseconds. */
    double getDrawingTime() const { return _drawingTime; }

private:
    void prepare();
    void unwrapSource();
    void legolize();
    void addOcclusion();
    void setOcclusion();
    void setProbe(const LightProbe& probe);
    osg::ref_ptr<LightProbe> createProbe() const;
    static void checkSupport(osg::GraphicsContext& context);
    void checkLegolized(const osg::State& state) const;
    void placeCamera(osg::Camera& camera) const;
    LegoSettings getSettings() const;
    /** The axis of the scene along which studs point. */
    UpAxis getUpAxis() const;
    [[noreturn]] void throwWithoutParts(const char* purpose) const;

    const CaptureOptions& _options;
    std::optional<PictureRenderer> _renderer; // from draw() on
    osg::ref_ptr<osg::Node> _source;
    LegoSettings _sourceSettings; // settings of the LegoNode that a pseudo-loader put above the mesh
    osg::ref_ptr<osg::Node> _shown;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    bool _isRead = false;       // the source is from a file,
    bool _hasOwnBricks = false; // and is in bricks there
    double _readingTime = 0.0;
    double _drawingTime = 0.0;
};

} // namespace osgLego
