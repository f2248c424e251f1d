#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The light that is hidden from the surroundings of bricks, for each voxel of a grid; some voxels lack a part of it.
 *
 * Different voxels may be written by different threads at once.
 */
class OcclusionVolume
{
public:
    /** The light that is hidden from a voxel. */
    struct Light
    {
        /** The hidden fraction, 0 to 1, from surfaces across each axis: the mean of both directions. */
        glm::vec3 mean{0.0f};
        /** Half the difference between upper and lower ends: more is hidden in this direction. -0.5 to 0.5. */
        glm::vec3 bend{0.0f};
        /** The hidden fraction from all surfaces. */
        float distant = 0.0f;
    };

    /** The parts of Light, as places in a set of bits. */
    static constexpr int MEAN = 0; //!< 3 bits, one for each axis
    static constexpr int BEND = 3; //!< likewise
    static constexpr int DISTANT = 6;
    static constexpr unsigned int ALL = 127;

    explicit OcclusionVolume(const glm::ivec3& size);

    /** Set the light of a voxel. @param parts the bits of those that are known. */
    void set(const glm::ivec3& voxel, const Light& light, unsigned int parts);

    /** The neighbours of a voxel that count. */
    enum class Neighbors
    {
        ALL,     //!< 26
        IN_PLANE //!< for surfaces across an axis, the four in the same plane that share a side with the voxel
    };

    /** Fill in what voxels lack by the mean of their neighbours that have it. Those that have no such neighbour stay as
     * they are.
     * @param isFilled whether to fill a voxel, called from several threads at once. */
    void fillFromNeighbors(Neighbors neighbors, const std::function<bool(const glm::ivec3&)>& isFilled);
    /** Fill in what voxels lack by the mean of a block of 2 x 2 x 2 that has it, or else of larger blocks, so that the
     * mean of a block is that of its voxels that have light. */
    void fillFromBlocks();

    /** Create images of bytes: the mean in red, green and blue, and the distant fraction in alpha; and the bend plus
     * 128 / 255. What voxels lack is 0. */
    std::array<osg::ref_ptr<osg::Image>, 2> createImages() const;

private:
    static constexpr std::size_t NUM_VALUES = 7;

    struct Voxel
    {
        std::array<std::uint8_t, NUM_VALUES> values{0, 0, 0, 128, 128, 128, 0};
        std::uint8_t parts = 0;
    };

    class Mean;

    std::size_t getPlace(const glm::ivec3& voxel) const
    {
        return static_cast<std::size_t>(voxel.x + _size.x * (voxel.y + _size.y * voxel.z));
    }
    Voxel getMean(const glm::ivec3& first, const glm::ivec3& last) const;
    Voxel getMeanAround(const glm::ivec3& voxel, Neighbors neighbors) const;
    void complete(const glm::ivec3& voxel, const Voxel& other);

    glm::ivec3 _size;
    std::vector<Voxel> _voxels;
};

} // namespace osgLego
