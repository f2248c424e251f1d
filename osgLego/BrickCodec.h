#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>

#include <string>
#include <string_view>

#include <osg/ref_ptr>

namespace osgLego
{

/** Encode a model compactly, for files and networks: its grid, and the cells and colours of its bricks or, if they are
 * joined to parts, the parts with their sizes, colours and colour codes, compressed and protected by a check sum. The
 * bytes are the same on every machine.
 *
 * Preconditions:
 * 1. The bricks are in the grid, sorted and unique, as in every model from BrickModel::create() and createOfParts().
 *
 * Usage:
 *
 *     const std::string bytes = osgLego::encodeBricks(*lego->getBricks());
 *     std::string error;
 *     const osg::ref_ptr<const osgLego::BrickModel> model = osgLego::decodeBricks(bytes, error);
 *     if (model)
 *         lego->setStoredBricks(model);
 *     else
 *         std::cerr << error << '\n';
 *
 * Needs no GL; may be called from any thread. Needs about 20 bytes of memory for each brick.
 * @return an empty string, with a warning, if a part has more than 48 cells, those of a 2x8 brick in plates, or the
 * model exceeds GridLimits.
 * @throws std::bad_alloc if there is not enough memory. */
OSGLEGO_EXPORT std::string encodeBricks(const BrickModel& model);

/** Decode the bytes of encodeBricks(), of this version or an older one, into an equal model. May be called from any
 * thread.
 * @return null, with one sentence in `error`, if the bytes are damaged or incomplete, in the format of a newer version,
 * or of a model that encodeBricks() refuses. Needs up to 20 bytes of memory for each brick, and 40 for each cell of
 * parts: at most 2.5 gigabytes, those of the largest model within GridLimits.
 * @throws std::bad_alloc if there is not enough memory. */
OSGLEGO_EXPORT osg::ref_ptr<const BrickModel> decodeBricks(std::string_view bytes, std::string& error);

} // namespace osgLego
