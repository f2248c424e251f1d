#include <osgLego/data/VolumeMipmaps.h>

#include <osgLego/data/MipmapFootprint.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
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

std::vector<MipmapFootprint> createFootprints(int narrow, int wide)
{
    std::vector<MipmapFootprint> footprints;
    footprints.reserve(static_cast<std::size_t>(narrow));
    for (int index = 0; index < narrow; ++index)
        footprints.emplace_back(index, narrow, wide);
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
        for (const MipmapFootprint& row : _rows)
            for (const MipmapFootprint& column : _columns)
            {
                const glm::vec4 mean = getMean(column, row, _layers[static_cast<std::size_t>(z)]);
                for (int channel = 0; channel < static_cast<int>(CHANNELS); ++channel)
                    *texel++ = static_cast<unsigned char>(std::lround(mean[channel]));
            }
    }

    glm::vec4 getMean(const MipmapFootprint& column, const MipmapFootprint& row, const MipmapFootprint& layer) const
    {
        glm::vec4 sum(0.0f);
        for (std::size_t z = 0; z < layer.weights.size(); ++z)
            for (std::size_t y = 0; y < row.weights.size(); ++y)
            {
                const unsigned char* texel = _bytes + _from.getPlace(column.first, row.first + static_cast<int>(y),
                                                                     layer.first + static_cast<int>(z));
                const float weight = row.weights[y] * layer.weights[z];
                for (const float share : column.weights)
                {
                    sum += weight * share * glm::vec4(texel[0], texel[1], texel[2], texel[3]);
                    texel += CHANNELS;
                }
            }
        return sum;
    }

    unsigned char* _bytes;
    Level _from;
    Level _to;
    std::vector<MipmapFootprint> _columns;
    std::vector<MipmapFootprint> _rows;
    std::vector<MipmapFootprint> _layers;
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
