#include <osgLego/flattening/KeptLattice.h>

namespace osgLego
{

namespace
{

// A surface at the end of a grid of a lattice belongs to the next cell. Cells larger by this share contain the surfaces
// at both ends of a source that a grid was fitted to.
constexpr double ENLARGEMENT = 1e-4;

/** The grid of the first source; its cells are slightly larger than fitted ones, around the same middle. */
BrickGrid findLattice(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    BrickGrid grid = BrickGrid::fit(bounds, settings);
    if (settings.grid.anchor != Anchor::FIRST)
    {
        grid.origin = glm::dvec3(0.0);
        return grid;
    }
    grid.origin -= 0.5 * ENLARGEMENT * grid.cellSize * glm::dvec3(grid.dimensions);
    grid.cellSize *= 1.0 + ENLARGEMENT;
    return grid;
}

} // namespace

LegoSettings KeptLattice::apply(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    if (!settings.givesSameBricks(_settings)) _lattice.reset();
    _settings = settings;
    if (settings.grid.anchor == Anchor::FIT || settings.grid.cellPitch) return settings;
    if (!_lattice)
    {
        const BrickGrid lattice = findLattice(bounds, settings);
        if (lattice.getNumCells() == 0) return settings;
        _lattice = lattice;
    }
    LegoSettings stated = settings;
    stated.grid.resolution = LegoSettings::Grid().resolution;
    stated.grid.cellPitch = _lattice->getPitch();
    stated.grid.origin = _lattice->origin;
    return stated;
}

} // namespace osgLego
