#include "HiddenParts.h"

#include <common/BrickRayCaster.h>
#include <osgLego/data/GrazingView.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace osgLego
{

namespace
{

/** The share of the faces of a part towards the eye, those that are not grazing, from which a ray reaches the eye. */
double findVisibleShare(const BrickRayCaster& caster, const Part& part, const glm::dvec3& toEye)
{
    constexpr int SAMPLES = 3;     // along each edge of a cell; some are beside its stud
    constexpr double ABOVE = 1e-4; // pitches
    const BrickGrid& grid = caster.getModel().getGrid();
    const glm::dvec3 scale = grid.cellSize / grid.getPitch();
    const glm::dvec3 origin = glm::dvec3(part.getCell()) * scale + ABOVE * toEye;
    int numRays = 0;
    int numVisible = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
        if (isGrazing(toEye[axis])) continue;
        glm::ivec3 counts = SAMPLES * part.getSize();
        counts[axis] = 1;
        for (int z = 0; z < counts.z; ++z)
            for (int y = 0; y < counts.y; ++y)
                for (int x = 0; x < counts.x; ++x, ++numRays)
                {
                    glm::dvec3 place = (glm::dvec3(x, y, z) + 0.5) / static_cast<double>(SAMPLES);
                    place[axis] = toEye[axis] > 0.0 ? part.getSize()[axis] : 0.0;
                    const auto hit =
                        caster.findNearest(origin + place * scale, toEye, std::numeric_limits<double>::infinity());
                    numVisible += hit ? 0 : 1;
                }
    }
    return static_cast<double>(numVisible) / numRays;
}

} // namespace

std::vector<std::uint32_t> findHiddenParts(const BrickModel& model, std::span<const std::uint32_t> placed,
                                           std::span<const std::uint32_t> shown, const glm::dvec3& toEye,
                                           double leastShare)
{
    std::vector<Part> inPlace;
    for (const std::uint32_t part : placed)
        inPlace.push_back(model.getParts()[part]);
    const BrickRayCaster caster(*BrickModel::createOfParts(model.getGrid(), std::move(inPlace)));
    std::vector<std::uint32_t> hidden;
    std::copy_if(shown.begin(), shown.end(), std::back_inserter(hidden),
                 [&](std::uint32_t part)
                 { return findVisibleShare(caster, model.getParts()[part], toEye) < leastShare; });
    return hidden;
}

} // namespace osgLego
