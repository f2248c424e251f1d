#pragma once

#include <cstddef>

namespace osgLego
{

/** The GL objects of a context, and the bytes of their contents as GL describes them: without the overhead of the
 * driver.
 */
struct GlObjectCount
{
    std::size_t numBuffers = 0;
    std::size_t numTextures = 0;
    std::size_t numPrograms = 0;
    double bufferBytes = 0.0;
    double textureBytes = 0.0; //!< of all levels; without textures that show buffers, and without samples

    /** Count the objects of the current context. Throws std::runtime_error without GL 4.5, whose functions this needs.
     */
    static GlObjectCount count();
};

} // namespace osgLego
