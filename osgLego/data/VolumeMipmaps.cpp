#include <osgLego/data/VolumeMipmaps.h>

#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

namespace
{

constexpr std::size_t CHANNELS = 4;

struct Level
{
    glm::ivec3 size;
    std::size_t offset; // in bytes

    std::size_t getPlace(int x, int y, int z) const
    {
        return offset + CHANNELS * static_cast<std::size_t>(x + size.x * (y + size.y * z));
    }
    std::size_t getEnd() const { return getPlace(0, 0, size.z); }
};

std::vector<Level> createLevels(const glm::ivec3& size)
{
    std::vector<Level> levels{{size, 0}};
    while (levels.back().size != glm::ivec3(1))
        levels.push_back({glm::max(levels.back().size / 2, 1), levels.back().getEnd()});
    return levels;
}

/** The texels of a longer side that one texel of a shorter side covers. */
struct Footprint
{
    int first;
    int count;                    // at most 3, of a side of three texels that becomes one
    std::array<float, 3> weights; // whose sum is 1
};

std::vector<Footprint> createFootprints(int shorter, int longer)
{
    std::vector<Footprint> footprints;
    const double length = static_cast<double>(longer) / shorter;
    for (int index = 0; index < shorter; ++index)
    {
        const double begin = index * length;
        Footprint footprint{static_cast<int>(begin), 0, {}};
        for (int texel = footprint.first; texel < longer && texel < begin + length - 1e-6; ++texel)
            footprint.weights.at(static_cast<std::size_t>(footprint.count++)) = static_cast<float>(
                (std::min(begin + length, texel + 1.0) - std::max(begin, static_cast<double>(texel))) / length);
        footprints.push_back(footprint);
    }
    return footprints;
}

/** Makes the texels of a level from those of the level before. */
class LevelWriter
{
public:
    LevelWriter(unsigned char* bytes, const Level& from, const Level& to) :
        _bytes(bytes), _from(from), _to(to), _columns(createFootprints(to.size.x, from.size.x)),
        _rows(createFootprints(to.size.y, from.size.y)), _layers(createFootprints(to.size.z, from.size.z))
    {
    }

    void write() const
    {
        forEachIndex(_layers.size(), [this](std::size_t z) { writeLayer(static_cast<int>(z)); });
    }

private:
    void writeLayer(int z) const
    {
        unsigned char* texel = _bytes + _to.getPlace(0, 0, z);
        for (const Footprint& row : _rows)
            for (const Footprint& column : _columns)
            {
                const glm::vec4 mean = getMean(column, row, _layers[static_cast<std::size_t>(z)]);
                for (int channel = 0; channel < static_cast<int>(CHANNELS); ++channel)
                    *texel++ = static_cast<unsigned char>(std::lround(mean[channel]));
            }
    }

    glm::vec4 getMean(const Footprint& column, const Footprint& row, const Footprint& layer) const
    {
        glm::vec4 sum(0.0f);
        for (int z = 0; z < layer.count; ++z)
            for (int y = 0; y < row.count; ++y)
            {
                const unsigned char* texel = _bytes + _from.getPlace(column.first, row.first + y, layer.first + z);
                const float weight =
                    row.weights[static_cast<std::size_t>(y)] * layer.weights[static_cast<std::size_t>(z)];
                for (int x = 0; x < column.count; ++x, texel += CHANNELS)
                    sum += weight * column.weights[static_cast<std::size_t>(x)] *
                           glm::vec4(texel[0], texel[1], texel[2], texel[3]);
            }
        return sum;
    }

    unsigned char* _bytes;
    Level _from;
    Level _to;
    std::vector<Footprint> _columns;
    std::vector<Footprint> _rows;
    std::vector<Footprint> _layers;
};

} // namespace

osg::ref_ptr<osg::Image> createVolumeMipmaps(const osg::Image& image)
{
    const std::vector<Level> levels = createLevels({image.s(), image.t(), image.r()});
    auto* bytes = new unsigned char[levels.back().getEnd()]; // osg::Image frees it with delete[]
    osg::ref_ptr<osg::Image> result = new osg::Image;
    result->setImage(image.s(), image.t(), image.r(), GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, bytes,
                     osg::Image::USE_NEW_DELETE);
    std::copy_n(image.data(), levels.front().getEnd(), bytes);
    osg::Image::MipmapDataType offsets;
    for (std::size_t level = 1; level < levels.size(); ++level)
    {
        LevelWriter(bytes, levels[level - 1], levels[level]).write();
        offsets.push_back(static_cast<unsigned int>(levels[level].offset));
    }
    result->setMipmapLevels(offsets);
    return result;
}

} // namespace osgLego
