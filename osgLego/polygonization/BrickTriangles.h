#pragma once

#include <osgLego/BrickModel.h>

#include <cstddef>
#include <optional>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The brick and the part of it that a triangle of createBrickGeometry or acceptBrickTriangles belongs to. */
struct BrickTriangle
{
    Brick brick;
    BrickSide side = SIDE_LEFT; //!< for a stud, the upper side
    bool isStud = false;
};

/** Whether the stud of a brick is exposed. */
bool hasStud(const Brick& brick, const BrickGrid& grid);

/** Find the triangle with the given index, by counting the triangles of the bricks before it.
 * @return nothing if there are fewer triangles. */
std::optional<BrickTriangle> findBrickTriangle(const BrickModel& model, std::size_t index);

/** User data of a geometry: the model from which the geometry was created. */
class BrickModelHolder : public osg::Referenced
{
public:
    explicit BrickModelHolder(const BrickModel& model) : _model(&model) {}

    const BrickModel& getModel() const { return *_model; }

private:
    ~BrickModelHolder() override = default;

    osg::ref_ptr<const BrickModel> _model;
};

} // namespace osgLego
