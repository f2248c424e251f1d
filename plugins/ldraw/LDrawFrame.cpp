#include "LDrawFrame.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** The axes of a part, whose long side lies along x. @param size in studs, along x and y. */
glm::dmat3 toAxes(const glm::ivec2& size)
{
    if (size.x >= size.y) return glm::dmat3(1.0);
    return {{0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
}

} // namespace

LDrawFrame::LDrawFrame(const BrickModel& model) :
    _model(model), _grid(model.getGrid()), _plates(getCellPlates(model.getGrid())),
    _lowest(std::numeric_limits<int>::max()), _end(std::numeric_limits<int>::min())
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

/** A place in cells, counted from the lowest ones, in LDraw's coordinates. */
glm::dvec3 LDrawFrame::toPlace(const glm::dvec3& cell) const
{
    const glm::dvec3 middle = cell - 0.5 * glm::dvec3(_end - _lowest);
    return {LDrawLattice::STUD * middle.x, -LDrawLattice::PLATE * cell.z, LDrawLattice::STUD * middle.y};
}

LDrawTransform LDrawFrame::getTransform(const Part& part) const
{
    const LatticeBox box = toBox(part);
    const glm::dvec3 size(box.size);
    LDrawTransform transform;
    // The origin of a part is the centre of its top face.
    transform.place = toPlace(glm::dvec3(box.place) + size * glm::dvec3(0.5, 0.5, 1.0));
    transform.axes = toAxes(box.size);
    return transform;
}

std::vector<LDrawTransform> LDrawFrame::getTransforms(const BasePlate& plates) const
{
    const glm::dvec2 size(plates.getPlateSize());
    const glm::dvec2 margin(plates.getMargin());
    std::vector<LDrawTransform> transforms;
    for (int row = 0; row < plates.getCounts().y; ++row)
        for (int column = 0; column < plates.getCounts().x; ++column)
        {
            const glm::dvec2 middle = (glm::dvec2(column, row) + 0.5) * size - margin;
            transforms.push_back({toAxes(plates.getPlateSize()), toPlace({middle, 0.0})});
        }
    return transforms;
}

glm::dvec3 LDrawFrame::getBottomCenter(std::span<const std::uint32_t> parts) const
{
    glm::ivec3 lowest = toBox(_model.getParts()[parts.front()]).place;
    glm::ivec3 end = lowest;
    for (const std::uint32_t part : parts)
    {
        const LatticeBox box = toBox(_model.getParts()[part]);
        lowest = glm::min(lowest, box.place);
        end = glm::max(end, box.place + box.size);
    }
    return toPlace({0.5 * (lowest.x + end.x), 0.5 * (lowest.y + end.y), static_cast<double>(lowest.z)});
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
