#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** A colour, and its share of a surface in any unit. */
struct ColorShare
{
    std::array<std::uint8_t, 3> color{};
    double weight = 0.0;

    bool operator==(const ColorShare&) const = default;
};

/** The colours of a surface and their weights. Colours that differ by less than 8 levels of 256 may be joined into
 * their mean.
 *
 * Usage:
 *
 *     ColorHistogram histogram;
 *     for (const Brick& brick : model->getBricks())
 *         histogram.add(brick.color, 1.0);
 *     const osg::ref_ptr<const Palette> best = chooseColors(palette, histogram, 8);
 *
 * One thread at a time.
 */
class ColorHistogram
{
public:
    /** Add a colour. @param weight at least 0 and finite. */
    void add(const std::array<std::uint8_t, 3>& color, double weight);

    /** The colours with a weight above 0, in an order that depends only on the colours. */
    std::vector<ColorShare> getShares() const;

private:
    static constexpr unsigned int SIDE = 32; // bins along each channel

    struct Bin
    {
        std::array<double, 3> sum{}; // of the channels times their weights
        double weight = 0.0;
    };

    std::vector<Bin> _bins = std::vector<Bin>(std::size_t(SIDE) * SIDE * SIDE);
};

} // namespace osgLego
