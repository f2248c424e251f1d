#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace osgLego
{

/** A context to measure in, current when this returns. Throws std::runtime_error when there is none.
 * @param width, height of its own frame buffer, in pixels. */
osg::ref_ptr<osg::GraphicsContext> createBenchContext(int width = 16, int height = 16);

/** A document of figures, as yet with the name of the benchmark, and with where and when it was measured: renderer,
 * version of GL, processor, threads, commit, date.
 * @param context is made current. */
nlohmann::ordered_json createDocument(const std::string& benchmark, osg::GraphicsContext& context);

/** Whether the renderer of the current context runs on the processor. */
bool isSoftwareRenderer();

} // namespace osgLego
