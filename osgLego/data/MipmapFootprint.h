#pragma once

#include <algorithm>
#include <vector>

namespace osgLego
{

/** The texels of a wider row that one texel of a narrower row averages, with their weights, whose sum is 1. */
struct MipmapFootprint
{
    /** @param index of the texel in the narrower row. @param narrow, wide the numbers of texels of the rows. */
    MipmapFootprint(int index, int narrow, int wide)
    {
        const double scale = static_cast<double>(wide) / narrow;
        const double begin = index * scale;
        const double end = begin + scale;
        first = static_cast<int>(begin);
        for (int texel = first; texel < wide && texel < end; ++texel)
            weights.push_back(
                static_cast<float>((std::min(end, texel + 1.0) - std::max(begin, static_cast<double>(texel))) / scale));
    }

    int first = 0;
    std::vector<float> weights;
};

} // namespace osgLego
