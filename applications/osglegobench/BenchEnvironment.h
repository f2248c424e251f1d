#pragma once

#include <common/JsonValue.h>

#include <string>

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create a context to measure in and make it current. Throws std::runtime_error if this fails.
 * @param width, height the size of its own frame buffer, in pixels. */
osg::ref_ptr<osg::GraphicsContext> createBenchContext(int width = 16, int height = 16);

/** Create a document of figures that contains the name of the benchmark and the environment: processor, threads,
 * commit, date. */
JsonValue createDocument(const std::string& benchmark);

/** The same for a benchmark that uses GL: the environment also contains the renderer and the version of GL.
 * @param context is made current. */
JsonValue createDocument(const std::string& benchmark, osg::GraphicsContext& context);

/** Whether the renderer of the current context runs on the processor. */
bool isSoftwareRenderer();

} // namespace osgLego
