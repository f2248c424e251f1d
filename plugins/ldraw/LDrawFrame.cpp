#include "LDrawFrame.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace osgLego
{

LDrawFrame::LDrawFrame(const BrickModel& model) :
    _grid(model.getGrid()), _plates(getCellPlates(model.getGrid())), _lowest(std::numeric_limits<int>::max()),
    _end(std::numeric_limits<int>::min())
{
    for (const Part& part : model.getParts())
    {
        const LatticeBox box = toGridBox(part);
        _lowest = glm::min(_lowest, box.place);
        _end = glm::max(_end, box.place + box.size);
    }
}

/** The cells of a part from the corner of the grid on. With y upwards, the model's z points towards the viewer, so that
 * rows are counted from the other end. */
LatticeBox LDrawFrame::toGridBox(const Part& part) const
{
    const glm::ivec3 cell = part.getCell();
    const glm::ivec3 size = part.getSize();
    if (_grid.upAxis == UpAxis::Z) return {{cell.x, cell.y, _plates * cell.z}, {size.x, size.y, _plates * size.z}};
    const int row = _grid.dimensions.z - cell.z - size.z;
    return {{cell.x, row, _plates * cell.y}, {size.x, size.z, _plates * size.y}};
}

LatticeBox LDrawFrame::toBox(const Part& part) const
{
    LatticeBox box = toGridBox(part);
    box.place -= _lowest;
    return box;
}

LDrawTransform LDrawFrame::getTransform(const Part& part) const
{
    const LatticeBox box = toBox(part);
    const glm::dvec3 extent(_end - _lowest);
    const glm::dvec3 size(box.size);
    const glm::dvec3 middle = glm::dvec3(box.place) + 0.5 * size - 0.5 * extent;
    LDrawTransform transform;
    // The origin of a part is the centre of its top face.
    transform.place = {LDrawLattice::STUD * middle.x, -LDrawLattice::PLATE * (box.place.z + box.size.z),
                       LDrawLattice::STUD * middle.y};
    // The long side of a part lies along x.
    if (box.size.x < box.size.y) transform.axes = {{0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
    return transform;
}

glm::dmat4 LDrawFrame::getModelTransform() const
{
    const bool isYUp = _grid.upAxis == UpAxis::Y;
    const double scale = _grid.getPitch() / LDrawLattice::STUD;
    // The images of LDraw's axes.
    const glm::dvec4 right(scale, 0.0, 0.0, 0.0);
    const glm::dvec4 down = scale * (isYUp ? glm::dvec4(0.0, -1.0, 0.0, 0.0) : glm::dvec4(0.0, 0.0, -1.0, 0.0));
    const glm::dvec4 away = scale * (isYUp ? glm::dvec4(0.0, 0.0, -1.0, 0.0) : glm::dvec4(0.0, 1.0, 0.0, 0.0));
    // The centre of the lowest layer, in cells of the grid.
    const glm::dvec3 center = 0.5 * glm::dvec3(_lowest + _end);
    const double bottom = static_cast<double>(_lowest.z) / _plates;
    const glm::dvec3 cells =
        isYUp ? glm::dvec3(center.x, bottom, _grid.dimensions.z - center.y) : glm::dvec3(center.x, center.y, bottom);
    return {right, down, away, glm::dvec4(_grid.origin + cells * _grid.cellSize, 1.0)};
}

} // namespace osgLego
