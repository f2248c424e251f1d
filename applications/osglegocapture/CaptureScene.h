#pragma once

#include "CaptureOptions.h"

#include <common/PartsList.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <vector>

#include <osg/BoundingSphere>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

class SceneReach;

/** The captured scene: a mesh and its bricks, by the options. ScenePicture draws it.
 *
 * Throws CaptureError. One thread.
 */
class CaptureScene
{
public:
    /** The purposes of parts, in messages. */
    static constexpr const char* TO_LIST = "to list";
    static constexpr const char* TO_STAND = "that could stand";
    static constexpr const char* TO_BUILD = "to build";

    /** Read the mesh, or create the built-in one. */
    explicit CaptureScene(const CaptureOptions& options);

    /** Use a node instead of a mesh; it may contain LegoNodes and AmbientOcclusionScenes. */
    CaptureScene(const CaptureOptions& options, const osg::ref_ptr<osg::Node>& node);

    /** The node to draw. */
    osg::Node& getNode() const { return *_shown; }
    /** The node that makes the bricks; null if the original mesh is drawn. */
    LegoNode* getLegoNode() const { return _lego.get(); }
    /** The only node that makes bricks, for a booklet. Throws CaptureError if there are others. */
    LegoNode& getOnlyLegoNode() const;
    /** Throw CaptureError if no settings and no stored bricks of the scene give parts, which is known before bricks are
     * made. @param purpose of the parts, for the message. */
    void checkHasParts(const char* purpose) const;
    /** The visible nodes that make or store bricks. */
    std::vector<LegoNode*> findLegoNodes() const;
    /** The parts of all bricks in the scene, and the base plates below them if the options name that base. Throws
     * CaptureError if there are no parts. */
    PartsList createPartsList() const;
    /** The models of the scene that have parts. Throws CaptureError if there are none. */
    std::vector<osg::ref_ptr<const BrickModel>> findPartModels() const;
    /** Draw a base plate below the bricks of getLegoNode(), which there must be, with their light.
     * @param plate in the coordinates of the bricks. Call at most once. */
    void addBasePlate(const BrickModel& plate);
    /** The node that adds ambient occlusion; null without ambient occlusion. */
    AmbientOcclusionScene* getOcclusionScene() const { return _occlusion.get(); }
    /** A sentence on files that the mesh names but that were not found; empty if there are none. */
    const std::string& getWarning() const { return _warning; }
    /** The time that reading the mesh took, in milliseconds. */
    double getReadingTime() const { return _readingTime; }
    /** The sphere about the scene according to which cameras are placed: that of the mesh, if there is one, not its
     * bricks, so that pictures of both match; without the base plate. */
    osg::BoundingSphere getBound() const;
    /** Add the scene, with all bricks that it may have. */
    void addTo(SceneReach& reach) const;
    /** The axis of the scene along which studs point. */
    UpAxis getUpAxis() const;

private:
    void prepare();
    void unwrapSource();
    void legolize();
    void addOcclusion();
    void setOcclusion();
    void setProbe(const LightProbe& probe);
    osg::ref_ptr<LightProbe> createProbe() const;
    bool isInSource() const;
    LegoSettings getSettings() const;
    [[noreturn]] void throwWithoutParts(const char* purpose) const;

    const CaptureOptions& _options;
    osg::ref_ptr<osg::Node> _source;
    LegoSettings _sourceSettings; // settings of the LegoNode that a pseudo-loader put above the mesh
    osg::ref_ptr<osg::Node> _shown;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<LegoNode> _basePlate; // null without one
    osg::ref_ptr<AmbientOcclusionScene> _occlusion;
    bool _isRead = false;       // the source is from a file,
    bool _hasOwnBricks = false; // and is in bricks there
    double _readingTime = 0.0;
    std::string _warning;
};

} // namespace osgLego
