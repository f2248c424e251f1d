#include <osgLego/palette/ColorHistogram.h>

#include <cmath>

namespace osgLego
{

void ColorHistogram::add(const std::array<std::uint8_t, 3>& color, double weight)
{
    constexpr unsigned int WIDTH = 256 / SIDE;
    Bin& bin = _bins[color[0] / WIDTH + SIDE * (color[1] / WIDTH + SIDE * (color[2] / WIDTH))];
    for (std::size_t channel = 0; channel < color.size(); ++channel)
        bin.sum[channel] += weight * color[channel];
    bin.weight += weight;
}

std::vector<ColorShare> ColorHistogram::getShares() const
{
    std::vector<ColorShare> shares;
    for (const Bin& bin : _bins)
    {
        if (!(bin.weight > 0.0)) continue;
        ColorShare share{{}, bin.weight};
        for (std::size_t channel = 0; channel < share.color.size(); ++channel)
            share.color[channel] = static_cast<std::uint8_t>(std::lround(bin.sum[channel] / bin.weight));
        shares.push_back(share);
    }
    return shares;
}

} // namespace osgLego
