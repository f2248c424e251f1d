#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/CellView.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <osg/FrameBufferObject>
#include <osg/Matrixd>
#include <osg/Referenced>
#include <osg/RenderInfo>
#include <osg/State>
#include <osg/Texture2D>
#include <osg/observer_ptr>
#include <osg/ref_ptr>
#include <osgUtil/RenderBin>

namespace osgLego
{

class BrickDrawable;

/** The current frame buffer and viewport, for restoring them. Needs the context of the state current. */
class SplatDestination
{
public:
    explicit SplatDestination(const osg::State& state);

    bool hasSamples() const { return _sampleBuffers > 0; }
    GLint getFrameBuffer() const { return _frameBuffer; }
    glm::ivec2 getOrigin() const { return {_viewport[0], _viewport[1]}; }
    glm::ivec2 getSize() const { return {_viewport[2], _viewport[3]}; }

    /** Limit the scissor test to the viewport until restore(), since GL does not clip the squares of points. */
    void clipPoints() const;
    void restore() const;

private:
    const osg::GLExtensions& _extensions;
    GLint _frameBuffer = 0;
    std::array<GLint, 4> _viewport{};
    std::array<GLint, 4> _scissor{};
    bool _isScissored = false;
    GLint _sampleBuffers = 0;
};

/** The picture that nodes are drawn into. Splats of nodes that have it in common are drawn into the same target without
 * clearing it for each node, which costs as much as drawing a small node, and bricks that are hidden by those of a
 * previous node are not shaded. */
struct SplatPicture
{
    const osgUtil::RenderBin* bin = nullptr; //!< others may clear the depths before they draw
    unsigned int frame = 0;
    GLint frameBuffer = 0;
    glm::ivec2 origin{0};
    glm::ivec2 size{0};
    osg::Matrixd view; // differs if a program draws several pictures of one frame number
    osg::Matrixd projection;
    glm::dvec2 depthRange{0.0, 1.0};

    bool operator==(const SplatPicture&) const = default;

    /** Find the picture that is being drawn. @return nothing if bricks may be visible there behind those of a previous
     * node, or if frames can't be distinguished. */
    static std::optional<SplatPicture> find(osg::RenderInfo& renderInfo, const SplatDestination& destination);
};

/** The splats of a node in a picture. */
struct SplatJob
{
    const BrickDrawable* node = nullptr; //!< with `modelView`, identifies the job
    osg::Matrixd modelView;
    osg::ref_ptr<osg::RefMatrix> cellsToEye;
    std::optional<CellView> view;
    CellView::Rays rays;
    BrickRanges ranges;
    // The bricks of the points; later, the node may have others.
    GLuint buffer = 0;
    const BrickBlock* blocks = nullptr;
    GLsizei firstSplat = 0; //!< the number of the first brick's splat
    GLsizei numSplats = 0;
    bool isPossible = false; //!< whether splats can draw the bricks
    bool isShaded = false;
};

/** The textures into which the splats of all nodes in a context are drawn. Contexts that share their objects have a
 * target each, since they don't share frame buffer objects. */
class SplatTarget : public osg::Referenced
{
public:
    /** The target of the current context, that of `state`, which its nodes share as long as one of them references it.
     */
    static osg::ref_ptr<SplatTarget> get(const osg::State& state);

    /** Whether this is the target of the context of a state. */
    bool belongsTo(const osg::State& state) const { return _owner == &state; }
    /** Whether the context has been closed. */
    bool isAbandoned() const { return !_owner.valid(); }
    /** Whether splats can be drawn, as far as is known. */
    bool isUsable() const { return !_hasFailed; }
    /** Stop using this target, with a message: a program or the frame buffer could not be created. */
    void fail();

    float getMaximumPointSize() const { return _maximumPointSize; }
    GLsizei getMaximumBricks() const { return _maximumBricks; }
    /** Whether a picture of the given size in pixels is not empty and not too large. */
    bool isPossible(const glm::ivec2& size) const
    {
        return size.x > 0 && size.y > 0 && size.x <= _maximumSize.x && size.y <= _maximumSize.y;
    }
    osg::Texture2D& getSplats() const { return *_splats; }
    osg::Texture2D& getDepths() const { return *_depths; }
    /** The texture for the buffer of the bricks that are drawn. */
    const GlTexture& getBricks() const { return _bricks; }

    /** The job of a node in the picture that is being drawn, whose points have been drawn; null if there is none. */
    SplatJob* find(const std::optional<SplatPicture>& picture, const BrickDrawable& node,
                   const osg::Matrixd& modelView);
    /** Start to draw a node into a picture, and possibly further nodes.
     * @param picture nothing: a picture of its own.
     * @return the number of jobs before. */
    std::size_t begin(const std::optional<SplatPicture>& picture, const BrickDrawable& node,
                      const osg::Matrixd& modelView);
    /** Add a job to the picture. It contains values of earlier pictures. */
    SplatJob& addJob();
    /** Number the splats of a job after those of the jobs before. @return whether there are enough numbers. */
    bool number(SplatJob& job, GLsizei count);
    std::size_t getNumJobs() const { return _numJobs; }
    SplatJob& getJob(std::size_t index) { return _jobs[index]; }

    /** Set a viewport of which the picture is the right half; points in the left half are outside the target. See
     * NOWHERE in splats.vert. @param size of the picture, in pixels. */
    static void setPointViewport(const glm::ivec2& size) { glViewport(-size.x, 0, 2 * size.x, size.y); }
    /** Bind the target for drawing points into the picture, and clear it the first time. The state for points is
     * applied.
     * @param size of the picture, in pixels. @return false if the target can't be created. */
    bool bind(osg::State& state, const glm::ivec2& size);

private:
    explicit SplatTarget(const osg::State& state);
    ~SplatTarget() override;

    void clearDepths(const glm::ivec2& size) const;
    void resize(const glm::ivec2& size);

    osg::observer_ptr<const osg::State> _owner;
    bool _hasFailed = false;
    float _maximumPointSize = 1.0f;
    glm::ivec2 _maximumSize{0};
    glm::ivec2 _size{0};
    GlTexture _bricks;
    GLsizei _maximumBricks = 0;
    osg::ref_ptr<osg::Texture2D> _splats;
    osg::ref_ptr<osg::Texture2D> _depths;
    osg::ref_ptr<osg::FrameBufferObject> _frameBuffer;

    std::optional<SplatPicture> _picture; // that is being drawn
    std::uint64_t _contents = 0;          // of its bin
    std::vector<SplatJob> _jobs;          // of the picture; further ones keep their memory
    std::size_t _numJobs = 0;
    std::size_t _nextJob = 0; // the one after the job that was found last
    GLsizei _numSplats = 0;   // of all jobs
    bool _isCleared = false;  // for the picture
};

} // namespace osgLego
