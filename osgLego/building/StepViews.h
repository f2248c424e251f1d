#pragma once

#include <osgLego/PlanningOptions.h>
#include <osgLego/data/SparseBox.h>
#include <osgLego/stability/JointGraph.h>

#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Chooses the direction from which each step of a model or submodel is shown, with as few quarter turns as possible.
 *
 * The first view is a given one, from the front right by default. Another one is chosen when other parts hide at least
 * half of the new ones, or nearly all of one of them.
 *
 * One thread. */
class StepViews
{
public:
    /** @param boxes those of all parts; they must outlive this object.
     * @param cellHeight the height of a cell, in studs.
     * @param view without turns.
     * @param mayPlanTurns whether canShow() counts other views than the first one; show() always does. */
    StepViews(const std::vector<BuildingBox>& boxes, double cellHeight, const BuildingView& view = {},
              bool mayPlanTurns = true);

    /** Put parts in place. @return the quarter turns, 0 to 3, counter-clockwise from above, that show them. */
    int show(const std::vector<std::uint32_t>& parts);

    /** Whether there is a view in which no part, if all of them were put in place, would be hidden. Parts of which less
     * than an eighth of the faces towards the eye is visible are hidden; faces that are seen edge-on don't count.
     * @param isTurning whether other views than the present one count. */
    bool canShow(const std::vector<std::uint32_t>& parts, bool isTurning);

private:
    /** The numbers of parts that a view shows well, and that it hides. */
    struct Sight
    {
        std::size_t numVisible = 0;
        std::size_t numHidden = 0;
    };

    void cover(const std::vector<std::uint32_t>& parts, bool isCovered);
    Sight look(const std::vector<std::uint32_t>& parts, int turns) const;
    double getVisibleShare(const BuildingBox& box, const glm::dvec3& toEye) const;
    bool isHidden(glm::dvec3 place, const glm::dvec3& toEye) const;

    const std::vector<BuildingBox>& _boxes;
    double _cellHeight;
    BuildingView _view;
    bool _mayPlanTurns;
    glm::ivec3 _lower{0};
    glm::ivec3 _size{0};
    SparseBox<bool> _isCovered; // cells from `_lower` on
    int _turns = 0;
};

} // namespace osgLego
