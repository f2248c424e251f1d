#pragma once

#include <osg/GL>
#include <osg/Texture>

namespace osgLego
{

/** The format of a texel of the voxel image, RGBA. shaders/passes/voxel_color.glsl defines the meaning of sums. */
enum class VoxelFormat
{
    COLOR,     //!< a colour in bytes, and an alpha of 1 in covered cells
    HALF_SUMS, //!< a sum of weighted colours and weights, as half floats
    FLOAT_SUMS //!< the same in single precision
};

/** The size of a texel. */
constexpr int bytesOf(VoxelFormat format)
{
    return format == VoxelFormat::COLOR ? 4 : format == VoxelFormat::HALF_SUMS ? 8 : 16;
}

constexpr GLint internalFormatOf(VoxelFormat format)
{
    return format == VoxelFormat::COLOR ? GL_RGBA8 : format == VoxelFormat::HALF_SUMS ? GL_RGBA16F_ARB : GL_RGBA32F_ARB;
}

} // namespace osgLego
