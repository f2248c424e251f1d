#include <osgLego/data/PartHighlight.h>

#include <algorithm>

namespace osgLego
{

PartHighlight::PartHighlight(const BrickModel& model, std::span<const std::size_t> parts, const Color& color) :
    _model(&model), _isHighlighted(model.getBricks().size()), _color(color[0] | color[1] << 8 | color[2] << 16)
{
    const std::vector<std::uint32_t>& partOfBrick = model.getPartIndices();
    std::vector<bool> isChosen(partOfBrick.empty() ? _isHighlighted.size() : model.getParts().size());
    for (const std::size_t part : parts)
        if (part < isChosen.size()) isChosen[part] = true;
    for (std::size_t brick = 0; brick < _isHighlighted.size(); ++brick)
        _isHighlighted[brick] = isChosen[partOfBrick.empty() ? brick : partOfBrick[brick]];
}

std::vector<BrickPoint> PartHighlight::apply(std::span<const BrickPoint> points) const
{
    constexpr std::uint32_t NUMBER = 0xff000000u;
    std::vector<BrickPoint> changed(points.begin(), points.end());
    for (BrickPoint& point : changed)
    {
        const Brick* brick = _model->find(unpackBrick(point).getCell());
        if (brick && _isHighlighted[static_cast<std::size_t>(brick - _model->getBricks().data())])
            point[2] = (point[2] & NUMBER) | _color;
    }
    return changed;
}

} // namespace osgLego
