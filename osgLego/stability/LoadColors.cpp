#include <osgLego/stability/LoadColors.h>

#include <osgLego/Stability.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

constexpr std::array<Color, 4> SCALE{{{49, 84, 190}, {38, 160, 90}, {240, 205, 40}, {205, 30, 30}}};
constexpr Color FALLING{220, 0, 200};
constexpr Color UNKNOWN{128, 128, 128};

} // namespace

std::array<std::uint8_t, 3> findLoadColor(float load)
{
    if (std::isnan(load)) return UNKNOWN;
    const float place = std::clamp(load, 0.0f, 1.0f) * static_cast<float>(SCALE.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), SCALE.size() - 2);
    const float share = place - static_cast<float>(below);
    Color color;
    for (std::size_t channel = 0; channel < color.size(); ++channel)
        color[channel] = static_cast<std::uint8_t>(std::lround(std::lerp(
            static_cast<float>(SCALE[below][channel]), static_cast<float>(SCALE[below + 1][channel]), share)));
    return color;
}

osg::ref_ptr<const BrickModel> colorByLoad(const BrickModel& model, const std::function<bool()>& isCancelled)
{
    if (model.getParts().empty()) return &model;
    const std::optional<StabilityReport> report = computeStability(model, {BuildingBase::TABLE, isCancelled});
    if (!report) return nullptr;
    std::vector<Part> parts = model.getParts();
    for (std::size_t part = 0; part < parts.size(); ++part)
        parts[part].color = findLoadColor(report->loads[part]);
    for (const std::uint32_t part : report->falling)
        parts[part].color = FALLING;
    return BrickModel::createOfParts(model.getGrid(), std::move(parts));
}

} // namespace osgLego
