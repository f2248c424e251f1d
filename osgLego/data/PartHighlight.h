#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickPoints.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** Parts of a model that are drawn in another colour.
 *
 * Immutable; every function may be called from any thread.
 */
class PartHighlight : public osg::Referenced
{
public:
    using Color = std::array<std::uint8_t, 3>; // red, green, blue (sRGB)

    /** @param parts their indices or, without parts, those of bricks; others than the model has are ignored. */
    PartHighlight(const BrickModel& model, std::span<const std::size_t> parts, const Color& color);

    const BrickModel& getModel() const { return *_model; }

    /** Points of the model's bricks, with this colour in those of the parts. */
    std::vector<BrickPoint> apply(std::span<const BrickPoint> points) const;

private:
    ~PartHighlight() override = default;

    osg::ref_ptr<const BrickModel> _model;
    std::vector<bool> _isHighlighted; // for each brick of the model
    std::uint32_t _color;             // in the format of BrickPoint
};

} // namespace osgLego
