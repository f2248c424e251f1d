#pragma once

#include "BookletFrame.h"

#include <osgLego/BrickGrid.h>
#include <osgLego/BrickModel.h>
#include <osgLego/Part.h>
#include <osgLego/PlanningOptions.h>

#include <span>

#include <glm/vec2.hpp>
#include <osg/Camera>
#include <osg/Quat>
#include <osg/Vec3d>

namespace osgLego
{

/** A direction in which a model is seen, without perspective. */
struct BookletView
{
    int turns = 0;             //!< quarter turns about the up axis, counter-clockwise from above
    bool isUpsideDown = false; //!< whether the model lies on its studs
    BuildingView front{};      //!< the view without turns
};

/** Places cameras so that pictures of a model from one direction have the same scale. */
class BookletCamera
{
public:
    BookletCamera(const BrickGrid& grid, const BookletView& view);

    /** The part of the picture's plane that parts cover, studs included. @param parts at least one. */
    BookletFrame findFrame(std::span<const Part> parts) const { return findFrame(parts, _grid); }
    /** Likewise of all parts of a model, which may be in another grid. */
    BookletFrame findFrame(const BrickModel& model) const { return findFrame(model.getParts(), model.getGrid()); }
    /** A point in cell units, in the picture's plane. */
    glm::dvec2 project(const glm::dvec3& cell) const;
    /** The start of a ray against getToEye() through a place of the picture's plane, in front of all bricks: in pitches
     * from the grid's origin, along the model's axes. */
    glm::dvec3 getStart(const glm::dvec2& place) const;
    /** The direction to the eye, in model coordinates, of length 1. */
    glm::dvec3 getToEye() const { return {_toEye.x(), _toEye.y(), _toEye.z()}; }
    /** The rotation from lights in the view of a default BuildingView to this view, so that lights turn with the
     * camera. Its elevation does not count: the sky remains above. */
    osg::Quat getLightTurn() const;
    /** Let a camera show a frame. */
    void apply(osg::Camera& camera, const BookletFrame& frame) const;

private:
    BookletFrame findFrame(std::span<const Part> parts, const BrickGrid& grid) const;

    BrickGrid _grid;
    osg::Vec3d _right;
    osg::Vec3d _up;
    osg::Vec3d _toEye;
    osg::Quat _lightTurn;
};

} // namespace osgLego
