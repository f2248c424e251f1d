#pragma once

#include <osgLego/BrickModel.h>

#include <cstddef>
#include <optional>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** Where a triangle of createBrickGeometry and acceptBrickTriangles lies. */
struct BrickTriangle
{
    Brick brick;
    BrickSide side = SIDE_LEFT; //!< of a stud: the side that it stands on
    bool isStud = false;
};

/** Whether a brick shows a stud. */
bool hasStud(const Brick& brick, const BrickGrid& grid);

/** The triangle of a number, by counting those of the bricks before; empty when there are not so many. */
std::optional<BrickTriangle> findBrickTriangle(const BrickModel& model, std::size_t index);

/** Keeps the model that a geometry was made of as that geometry's user data. */
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
