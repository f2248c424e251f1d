#include "ModelBound.h"

#include "Cancellation.h"

#include <common/LayoutBound.h>
#include <osgLego/Palette.h>
#include <osgLego/PartType.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

/** The sizes of the colours that parts have. */
std::vector<LayoutColor> findColors(const BrickModel& model, const LegoSettings& settings,
                                    std::map<Color, std::uint16_t>& indices)
{
    std::string ignored;
    const osg::ref_ptr<const Palette> palette = Palette::read(settings, ignored);
    std::vector<LayoutColor> colors;
    for (const Part& part : model.getParts())
    {
        if (!indices.emplace(part.color, static_cast<std::uint16_t>(colors.size())).second) continue;
        LayoutColor color;
        if (palette)
            for (const PaletteColor& known : palette->getColors())
                if (known.code == part.colorCode) color = {known.bricks, known.plates};
        colors.push_back(color);
    }
    return colors;
}

LayoutProblem createProblem(const BrickModel& model, const LegoSettings& settings)
{
    LayoutProblem problem;
    std::map<Color, std::uint16_t> indices;
    problem.colors = findColors(model, settings, indices);
    const auto up = static_cast<std::size_t>(model.getGrid().getUpIndex());
    const auto toLayout = [up](auto vector)
    {
        std::swap(vector[2], vector[up]);
        return vector;
    };
    const glm::ivec3& size = model.getGrid().dimensions;
    const auto turned = toLayout(std::array{size.x, size.y, size.z});
    problem.size = {turned[0], turned[1], turned[2]};
    for (std::size_t index = 0; index < model.getBricks().size(); ++index)
    {
        const Brick& brick = model.getBricks()[index];
        const std::uint16_t color = model.isAdded(index) ? LayoutCell::ANY_COLOR : indices.at(brick.color);
        problem.cells.push_back({toLayout(brick.cell), color});
    }
    std::sort(problem.cells.begin(), problem.cells.end(),
              [](const LayoutCell& a, const LayoutCell& b)
              { return std::tie(a.place[2], a.place[1], a.place[0]) < std::tie(b.place[2], b.place[1], b.place[0]); });
    return problem;
}

} // namespace

std::size_t computeModelBound(const LegoNode& lego)
{
    const osg::ref_ptr<const BrickModel> model = lego.getBricks();
    if (!model || model->getParts().empty() || getCellPlates(model->getGrid()) != 3) return 0;
    BoundOptions options;
    options.isCancelled = Cancellation::isRequested;
    std::size_t sum = 0;
    for (const LayerBound& layer : boundLayers(createProblem(*model, lego.getSettings()), {}, options))
        sum += layer.parts;
    Cancellation::check();
    return sum;
}

} // namespace osgLego
