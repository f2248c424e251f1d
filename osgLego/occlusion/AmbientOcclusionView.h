#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/occlusion/GeometryBufferStage.h>
#include <osgLego/occlusion/ScreenPass.h>

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <osg/FrameBufferObject>
#include <osg/Program>
#include <osg/Referenced>
#include <osg/Texture>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The values that determine buffers and programs. */
struct OcclusionFormat
{
    glm::ivec2 size{1}; //!< pixels
    int samples = 1;    //!< per pixel
    AmbientOcclusionQuality quality = AmbientOcclusionQuality::MEDIUM;
    bool hasDistant = false; //!< whether bricks write distant occlusion

    bool operator==(const OcclusionFormat&) const = default;
};

/** The programs and textures shared by all views of the same format and any size, since creating them is
 * expensive. */
struct AmbientOcclusionPrograms : public osg::Referenced
{
    AmbientOcclusionPrograms(const OcclusionFormat& format, const LightProbe& probe);

    osg::ref_ptr<osg::Program> resolve;
    osg::ref_ptr<osg::Program> tiles;
    osg::ref_ptr<osg::Program> occlusion;
    osg::ref_ptr<osg::Program> denoise;
    osg::ref_ptr<osg::Program> composite;
    osg::ref_ptr<osg::Texture2D> noise;
    osg::ref_ptr<osg::StateSet> light; //!< uniforms and textures of the probe

private:
    ~AmbientOcclusionPrograms() override = default;
};

/** The view of an AmbientOcclusionScene by one camera: the buffers, and the passes over them.
 *
 * If the format changes, a new view is created. Used by one cull visitor.
 */
class AmbientOcclusionView : public osg::Referenced
{
public:
    AmbientOcclusionView(const OcclusionFormat& format, const AmbientOcclusionPrograms& programs);

    const OcclusionFormat& getFormat() const { return _format; }

    /** Cull the children for the geometry buffer, then the passes and the composite.
     * @param bound of the children, in model coordinates.
     * @param hasBounds whether the bounds of all children say where they are drawn.
     * @param cullChildren traverses the children with the visitor. */
    void cull(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings, const osg::BoundingSphere& bound,
              bool hasBounds, const std::function<void()>& cullChildren);

    /** Whether the GPU had too little memory for the buffers. */
    bool hasFailed() const { return _stage->hasFailed(); }

    void setTiming(bool timing);
    AmbientOcclusionTimes getTimes() const;

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~AmbientOcclusionView() override;

    void createGeometryBuffer();
    void createPasses();
    void setUpStage(osgUtil::RenderStage& outer);

    OcclusionFormat _format;
    osg::ref_ptr<const AmbientOcclusionPrograms> _programs;
    osg::ref_ptr<GeometryBufferStage> _stage;
    osg::ref_ptr<osg::FrameBufferObject> _geometryBuffer;
    osg::ref_ptr<osg::Texture> _light;
    osg::ref_ptr<osg::Texture> _albedo;
    osg::ref_ptr<osg::Texture> _normals;
    osg::ref_ptr<osg::Texture> _depth;
    osg::ref_ptr<osg::Texture> _brickOcclusion; // see geometry_buffer.glsl
    // They distinguish the children's state graphs from those of other nodes.
    osg::ref_ptr<osg::StateSet> _childState;
    osg::ref_ptr<osg::StateSet> _transparentState;

    osg::ref_ptr<ScreenPass> _resolve;
    osg::ref_ptr<ScreenPass> _tiles;
    osg::ref_ptr<ScreenPass> _occlusion;
    osg::ref_ptr<ScreenPass> _denoise;
    osg::ref_ptr<ScreenPass> _composite;
    std::vector<osg::ref_ptr<ScreenPass>> _passes; // all of them, in order
    osg::ref_ptr<osg::Uniform> _radius;
    osg::ref_ptr<osg::Uniform> _shown;
};

} // namespace osgLego
