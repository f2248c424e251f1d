#include "NewPartMask.h"

#include <common/BrickRayCaster.h>

#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

namespace
{

constexpr double FAR = std::numeric_limits<double>::infinity();

osg::ref_ptr<const BrickModel> createModelOf(const BrickModel& model, std::span<const std::uint32_t> indices)
{
    std::vector<Part> parts;
    parts.reserve(indices.size());
    for (const std::uint32_t index : indices)
        parts.push_back(model.getParts()[index]);
    return BrickModel::createOfParts(model.getGrid(), std::move(parts));
}

/** Sees new parts behind earlier ones along rays of a camera. */
class NewPartRays
{
public:
    NewPartRays(const BrickModel& newParts, const BrickModel& earlier, const BookletCamera& camera) :
        _newParts(newParts), _earlier(earlier), _camera(camera)
    {
    }

    /** @param place in the picture's plane, in pitches. */
    bool isNew(const glm::dvec2& place) const
    {
        const glm::dvec3 start = _camera.getStart(place);
        const glm::dvec3 direction = -_camera.getToEye();
        const std::optional<double> distance = _newParts.findNearest(start, direction, FAR);
        return distance && !_earlier.findNearest(start, direction, *distance);
    }

private:
    BrickRayCaster _newParts;
    BrickRayCaster _earlier;
    const BookletCamera& _camera; // outlives this object
};

} // namespace

NewPartMask NewPartMask::create(const BrickModel& model, std::span<const std::uint32_t> placed, std::size_t numNew,
                                const BookletCamera& camera, const BookletFrame& frame, const glm::ivec2& picture,
                                int margin)
{
    const osg::ref_ptr<const BrickModel> newParts = createModelOf(model, placed.last(numNew));
    const NewPartRays rays(*newParts, *createModelOf(model, placed.first(placed.size() - numNew)), camera);
    const glm::dvec2 pitches = frame.getSize() / glm::dvec2(picture); // of a pixel
    const BookletFrame bounds = camera.findFrame(*newParts);
    const glm::dvec2 scale = pitches * static_cast<double>(PIXELS);
    NewPartMask mask;
    mask.lowest = glm::max(glm::ivec2(glm::floor((bounds.lowest - frame.lowest) / scale)) - margin, glm::ivec2(0));
    const glm::ivec2 end = glm::min(glm::ivec2(glm::ceil((bounds.highest - frame.lowest) / scale)) + margin,
                                    (picture + PIXELS - 1) / PIXELS);
    mask.size = glm::max(end - mask.lowest, glm::ivec2(0));
    for (int y = mask.lowest.y; y < end.y; ++y)
        for (int x = mask.lowest.x; x < end.x; ++x)
        {
            int number = 0;
            for (int row = PIXELS * y; row < PIXELS * (y + 1); ++row)
                for (int column = PIXELS * x; column < PIXELS * (x + 1); ++column)
                    number += rays.isNew(frame.lowest + (glm::dvec2(column, row) + 0.5) * pitches) ? 1 : 0;
            mask.shares.push_back(static_cast<float>(number) / static_cast<float>(PIXELS * PIXELS));
        }
    return mask;
}

} // namespace osgLego
