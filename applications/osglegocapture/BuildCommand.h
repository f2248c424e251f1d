#pragma once

#include "CaptureOptions.h"

#include <osg/GraphicsContext>

namespace osgLego
{

/** osglegocapture --build: choose the settings that make the best model of the mesh, and write it into a folder with
 * all that is needed to build it: a picture, instructions for screens, paper and ears, parts lists, the model in
 * LDraw's format, and a report on the choice.
 *
 * Throws CaptureError. Files are written atomically, after the choice. */
void buildModel(const CaptureOptions& given, osg::GraphicsContext& context);

} // namespace osgLego
