#pragma once

#include <optional>

#include <osg/GL>
#include <osg/GraphicsContext>

namespace osgLego
{

/** Measures between two GL commands by the GPU's own clock (GL_TIMESTAMP).
 *
 * Software renderers answer with the time at which they took the command, which says nothing; there it measures
 * nothing. Every function but the constructor needs the context current. */
class GpuStopwatch
{
public:
    GpuStopwatch() = default;
    ~GpuStopwatch() = default;
    GpuStopwatch(const GpuStopwatch&) = delete;
    GpuStopwatch& operator=(const GpuStopwatch&) = delete;

    void prepare(osg::GraphicsContext& context);
    void start() const;
    void stop() const;
    /** Milliseconds from start to stop, what the GPU waited in between included; waits for the GPU. */
    std::optional<double> getTime() const;
    void release();

private:
    osg::GLExtensions* _extensions = nullptr; // null: there is nothing to measure
    GLuint _queries[2] = {0, 0};
};

} // namespace osgLego
