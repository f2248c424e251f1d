#include <osgLego/data/OcclusionVolume.h>

#include <osgLego/data/ForEachVoxel.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

std::uint8_t toByte(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
}

osg::ref_ptr<osg::Image> createImage(const glm::ivec3& size)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size.x, size.y, size.z, GL_RGBA, GL_UNSIGNED_BYTE);
    return image;
}

} // namespace

OcclusionVolume::OcclusionVolume(const glm::ivec3& size) :
    _size(size), _voxels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y * size.z))
{
}

void OcclusionVolume::set(const glm::ivec3& voxel, const Light& light, unsigned int parts)
{
    Voxel& stored = _voxels[getPlace(voxel)];
    for (int axis = 0; axis < 3; ++axis)
    {
        stored.values[static_cast<std::size_t>(MEAN + axis)] = toByte(255.0f * light.mean[axis]);
        stored.values[static_cast<std::size_t>(BEND + axis)] = toByte(128.0f + 255.0f * light.bend[axis]);
    }
    stored.values[DISTANT] = toByte(255.0f * light.distant);
    stored.parts = static_cast<std::uint8_t>(parts);
}

/** The mean of voxels. */
class OcclusionVolume::Mean
{
public:
    /** @param parts the bits of those that count. */
    void add(const Voxel& voxel, unsigned int parts)
    {
        parts &= voxel.parts;
        if (parts == 0) return;
        for (std::size_t value = 0; value < NUM_VALUES; ++value)
        {
            const unsigned int counts = parts >> value & 1u;
            _sums[value] += counts * voxel.values[value];
            _counts[value] += counts;
        }
    }

    Voxel get() const
    {
        Voxel mean;
        for (std::size_t value = 0; value < NUM_VALUES; ++value)
        {
            if (_counts[value] == 0) continue;
            mean.values[value] = static_cast<std::uint8_t>((_sums[value] + _counts[value] / 2) / _counts[value]);
            mean.parts = static_cast<std::uint8_t>(mean.parts | 1u << value);
        }
        return mean;
    }

private:
    std::array<unsigned int, NUM_VALUES> _sums{};
    std::array<unsigned int, NUM_VALUES> _counts{};
};

/** The mean of a box of voxels, `last` included. */
OcclusionVolume::Voxel OcclusionVolume::getMean(const glm::ivec3& first, const glm::ivec3& last) const
{
    Mean mean;
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                mean.add(_voxels[getPlace({x, y, z})], ALL);
    return mean.get();
}

/** The mean of the neighbours of a voxel. */
OcclusionVolume::Voxel OcclusionVolume::getMeanAround(const glm::ivec3& voxel, Neighbors neighbors) const
{
    const glm::ivec3 first = glm::max(voxel - 1, 0);
    const glm::ivec3 last = glm::min(voxel + 1, _size - 1);
    if (neighbors == Neighbors::ALL) return getMean(first, last);
    Mean mean;
    for (int axis = 0; axis < 3; ++axis)
        for (const int end : {first[axis], last[axis]})
        {
            glm::ivec3 neighbor = voxel;
            neighbor[axis] = end;
            mean.add(_voxels[getPlace(neighbor)], ALL & ~(1u << (MEAN + axis)));
        }
    return mean.get();
}

/** Fill in what a voxel lacks. */
void OcclusionVolume::complete(const glm::ivec3& voxel, const Voxel& other)
{
    Voxel& completed = _voxels[getPlace(voxel)];
    for (std::size_t value = 0; value < NUM_VALUES; ++value)
        if ((other.parts & ~completed.parts) >> value & 1u) completed.values[value] = other.values[value];
    completed.parts |= other.parts;
}

void OcclusionVolume::fillFromNeighbors(Neighbors neighbors, const std::function<bool(const glm::ivec3&)>& isFilled)
{
    OcclusionVolume filled(*this);
    forEachVoxel(_size,
                 [&](const glm::ivec3& voxel)
                 {
                     if (isFilled(voxel)) filled.complete(voxel, getMeanAround(voxel, neighbors));
                 });
    _voxels.swap(filled._voxels);
}

void OcclusionVolume::fillFromBlocks()
{
    if (_size == glm::ivec3(1)) return;
    OcclusionVolume blocks((_size + 1) / 2);
    forEachVoxel(blocks._size, [&](const glm::ivec3& block)
                 { blocks._voxels[blocks.getPlace(block)] = getMean(2 * block, glm::min(2 * block + 1, _size - 1)); });
    blocks.fillFromBlocks();
    forEachVoxel(_size, [&](const glm::ivec3& voxel) { complete(voxel, blocks._voxels[blocks.getPlace(voxel / 2)]); });
}

std::array<osg::ref_ptr<osg::Image>, 2> OcclusionVolume::createImages() const
{
    const std::array<osg::ref_ptr<osg::Image>, 2> images{createImage(_size), createImage(_size)};
    unsigned char* mean = images[0]->data();
    unsigned char* bend = images[1]->data();
    for (const Voxel& voxel : _voxels)
    {
        mean = std::copy_n(voxel.values.begin() + MEAN, 3, mean);
        *mean++ = voxel.values[DISTANT];
        bend = std::copy_n(voxel.values.begin() + BEND, 3, bend);
        *bend++ = 255;
    }
    return images;
}

} // namespace osgLego
