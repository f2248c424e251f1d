#pragma once

#include "CaptureOptions.h"
#include "ProgressBar.h"

#include <osgLego/LegoNode.h>
#include <osgLego/PlanningOptions.h>
#include <osgLego/Stability.h>

#include <optional>
#include <string>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego
{

/** The names of the files of the booklet. */
std::vector<std::string> getInstructionsFiles(const CaptureOptions& options);

/** Throws CaptureError if the booklet's file can't be written. Call it before the work, which may take long. */
void checkInstructionsPlace(const CaptureOptions& options);

/** Throws CaptureError if a booklet of the node's parts would be very large, unless the options want it. */
void checkInstructionsSize(const CaptureOptions& options, const LegoNode& lego);

/** Results about the node's bricks that are known already. */
struct KnownResults
{
    std::optional<StabilityReport> stability;
    osg::ref_ptr<const BuildingPlan> plan; //!< on the base and for the view of the options; may be null
};

/** The view of the booklet. */
BuildingView getInstructionsView(const CaptureOptions& options);

/** Write a booklet of building instructions. Throws CaptureError. */
void writeInstructions(const CaptureOptions& options, const LegoNode& lego, const KnownResults& known,
                       osg::GraphicsContext& context, const ProgressBar& progress);

} // namespace osgLego
