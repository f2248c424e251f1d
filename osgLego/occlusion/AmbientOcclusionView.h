#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/occlusion/GeometryBufferStage.h>
#include <osgLego/occlusion/ScreenPass.h>

#include <functional>

#include <glm/vec2.hpp>
#include <osg/FrameBufferObject>
#include <osg/Program>
#include <osg/Referenced>
#include <osg/Texture>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** What views of one quality and number of samples share, whatever their size: it takes long to make. */
struct AmbientOcclusionPrograms : public osg::Referenced
{
    AmbientOcclusionPrograms(int samples, AmbientOcclusionQuality quality, const LightProbe& probe);

    osg::ref_ptr<osg::Program> resolve;
    osg::ref_ptr<osg::Program> occlusion;
    osg::ref_ptr<osg::Program> denoise;
    osg::ref_ptr<osg::Program> composite;
    osg::ref_ptr<osg::Texture2D> noise;
    osg::ref_ptr<osg::StateSet> light; //!< of the probe

private:
    ~AmbientOcclusionPrograms() override = default;
};

/** An AmbientOcclusionScene as one camera sees it: the buffers, and the passes over them.
 *
 * Made anew when what it is made for changes. Used by one cull visitor.
 */
class AmbientOcclusionView : public osg::Referenced
{
public:
    /** What decides buffers and programs. */
    struct Format
    {
        glm::ivec2 size{1}; //!< pixels
        int samples = 1;    //!< a pixel
        AmbientOcclusionQuality quality = AmbientOcclusionQuality::MEDIUM;

        bool operator==(const Format&) const = default;
    };

    AmbientOcclusionView(const Format& format, const AmbientOcclusionPrograms& programs);

    const Format& getFormat() const { return _format; }

    /** Cull children into the geometry buffer, and the passes and the composite behind them.
     * @param sceneRadius of the children's bound, in units of the world.
     * @param cullChildren traverses them with the visitor. */
    void cull(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings, double sceneRadius,
              const std::function<void()>& cullChildren);

    /** Whether there was no memory on the GPU for the buffers. */
    bool hasFailed() const { return _stage->hasFailed(); }

    void setTiming(bool timing);
    AmbientOcclusionTimes getTimes() const;

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~AmbientOcclusionView() override = default;

    void createGeometryBuffer();
    void createPasses();
    void setUpStage(osgUtil::RenderStage& outer);

    Format _format;
    osg::ref_ptr<const AmbientOcclusionPrograms> _programs;
    osg::ref_ptr<GeometryBufferStage> _stage;
    osg::ref_ptr<osg::FrameBufferObject> _geometryBuffer;
    osg::ref_ptr<osg::Texture> _light;
    osg::ref_ptr<osg::Texture> _albedo;
    osg::ref_ptr<osg::Texture> _normals;
    osg::ref_ptr<osg::Texture> _depth;
    // They tell the children's state graphs from those of others.
    osg::ref_ptr<osg::StateSet> _childState;
    osg::ref_ptr<osg::StateSet> _transparentState;

    osg::ref_ptr<ScreenPass> _resolve;
    osg::ref_ptr<ScreenPass> _occlusion;
    osg::ref_ptr<ScreenPass> _denoise;
    osg::ref_ptr<ScreenPass> _composite;
    osg::ref_ptr<osg::Uniform> _radius;
    osg::ref_ptr<osg::Uniform> _shown;
};

} // namespace osgLego
