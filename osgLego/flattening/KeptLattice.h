#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/LegoSettings.h>

#include <optional>

#include <osg/BoundingBox>

namespace osgLego
{

/** The lattice that the cells of a moving source belong to, by LegoSettings::Grid::anchor: found for the first source,
 * and kept until settings that give other bricks are used.
 *
 * One thread at a time.
 */
class KeptLattice
{
public:
    /** State the lattice as LegoSettings::Grid::cellPitch and `origin`.
     * @param bounds those of the source, in its coordinates, or with Anchor::WORLD in those of the world.
     * @return the same settings if the grid is fitted to each source, has a cell of a given size, or can't be fitted to
     * these bounds. */
    LegoSettings apply(const osg::BoundingBoxd& bounds, const LegoSettings& settings);

private:
    LegoSettings _settings; // for which the lattice was found
    std::optional<BrickGrid> _lattice;
};

} // namespace osgLego
