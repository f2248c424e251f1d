#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/ByteReader.h>
#include <osgLego/data/ByteWriter.h>

#include <vector>

namespace osgLego
{

// The data of stored bricks and parts, before it is compressed.
//
// Bricks: the runs of covered cells in the order of their numbers, then the reds, greens and blues of the bricks, 8
// bits each. A run is the number of empty cells before it, and its own length. A colour is stored as the difference
// from that of the brick before.
//
// Parts: for the parts in the order of their lowest cells, the differences of the numbers of these cells from those
// before, then the sizes along x, y and z, 8 bits each, then the reds, greens and blues, as above, then the colour
// codes, 32 bits each.
//
// Numbers without a size given here take 7 bits of each byte, lowest first; the highest bit is set in all bytes but the
// last.

void writeBricks(const BrickModel& model, ByteWriter& writer);
void writeParts(const BrickModel& model, ByteWriter& writer);

/** Fill in the bricks. @return false if the data ends early, or the runs leave the grid or have another number of
 * cells.
 */
bool readBricks(ByteReader& reader, const BrickGrid& grid, std::vector<Brick>& bricks);

/** Fill in the parts. @return false if the data ends early, a part leaves the grid, or two begin in the same cell. */
bool readParts(ByteReader& reader, const BrickGrid& grid, std::vector<Part>& parts);

} // namespace osgLego
