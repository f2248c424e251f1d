#pragma once

#include "BenchMeshes.h"
#include "OcclusionBench.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <functional>

#include <glm/vec2.hpp>
#include <osg/Camera>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osgViewer/Viewer>

namespace osgLego
{

/** What becomes of the pictures that a BenchView draws. */
enum class PictureUse
{
    BRING_BACK, //!< to main memory, which takes time that drawing alone does not
    DISCARD
};

/** A mesh at a resolution, with the usual settings else, seen as scenes are. */
BenchScene createBenchScene(const MeshSource& source, unsigned int resolution);

/** The mesh that a scene names. Throws std::runtime_error when it can't be read. */
osg::ref_ptr<osg::Node> createBenchMesh(const std::string& name);

/** Let a camera look at bricks as a scene says. */
void placeCamera(osg::Camera& camera, const BenchScene& scene, const osg::BoundingSphere& bound, double aspectRatio);

/** A scene of the bench before a camera that draws pictures of floats, each in a context of its own. Throws
 * std::runtime_error. One thread. */
class BenchView
{
public:
    BenchView(const BenchScene& scene, const glm::ivec2& size, PictureUse use = PictureUse::BRING_BACK);

    /** Draw, and wait until that is done. */
    void drawFrame(const AmbientOcclusionSettings& settings);
    /** Draw, and bring the picture back, as PictureUse must say: RGBA of floats, its first row at the bottom. */
    osg::ref_ptr<osg::Image> draw(const AmbientOcclusionSettings& settings);

    /** The point on a pixel's near plane, and the direction from there, in the coordinates of the model. */
    void getRay(const glm::ivec2& pixel, osg::Vec3d& origin, osg::Vec3d& direction) const;
    /** From directions of the eye's coordinates to those of the model. */
    osg::Vec3d toModel(const osg::Vec3d& eyeDirection) const;

    LegoNode& getLegoNode() const { return *_lego; }
    AmbientOcclusionScene& getScene() const { return *_scene; }
    osg::GraphicsContext& getContext() { return *_viewer.getCamera()->getGraphicsContext(); }
    AmbientOcclusionTimes getTimes() const;
    /** Of the last legolization. */
    LegoStatistics getStatistics() const;

private:
    void attachTarget(PictureUse use);

    unsigned int getContextID() const { return _viewer.getCamera()->getGraphicsContext()->getState()->getContextID(); }

    osgViewer::Viewer _viewer; // closes the context when it goes
    glm::ivec2 _size;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<AmbientOcclusionScene> _scene;
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osg::Image> _image;
};

} // namespace osgLego
