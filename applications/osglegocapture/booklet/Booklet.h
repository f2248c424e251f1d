#pragma once

#include "../CaptureOptions.h"

#include <common/PartsList.h>
#include <osgLego/LegoNode.h>

#include <functional>
#include <string>

#include <osg/GraphicsContext>

namespace osgLego
{

/** The file that options ask for. */
std::string getBookletFile(const CaptureOptions& options);

/** Throws CaptureError if the booklet's file can't be written. Call it before the work, which may take long. */
void checkBookletPlace(const CaptureOptions& options);

/** Write a booklet of building instructions: one HTML file, complete or not at all.
 *
 * SIGINT and SIGTERM cancel it. Throws CaptureError.
 * @param lego gets the building plan.
 * @param createContext is called once it is known that there is something to draw. */
void writeBooklet(const CaptureOptions& options, LegoNode& lego,
                  const std::function<osg::ref_ptr<osg::GraphicsContext>()>& createContext);

} // namespace osgLego
