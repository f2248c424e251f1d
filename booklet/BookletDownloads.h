#pragma once

#include "BookletModel.h"
#include "BookletPage.h"

#include <common/ModelHeader.h>
#include <osgLego/LegoNode.h>

#include <string>
#include <vector>

#include <osgDB/ReaderWriter>

namespace osgLego
{

/** The plugin that writes LDraw's files. Throws BookletFailure if osgDB does not find it. */
osgDB::ReaderWriter& findLDrawWriter();

/** The files that readers save from a booklet: a wanted list, a parts list, and the model in LDraw's format. Throws
 * BookletFailure.
 * @param name of the files, without an extension.
 * @param lego with stored bricks and their building plan.
 * @param header of the model in LDraw's format. */
std::vector<BookletDownload> createDownloads(const std::string& name, const BookletModel& model, const LegoNode& lego,
                                             const ModelHeader& header);

} // namespace osgLego
