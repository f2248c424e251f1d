#pragma once

#include <cstddef>

#include <osg/GraphicsContext>

namespace osgLego::test
{

/** Lets a call of GL fail in a context. */
class GlFaults
{
public:
    /** What fails. */
    enum class Kind
    {
        SHADER,      //!< the compilation of a shader
        PROGRAM,     //!< the linking of a program
        FRAMEBUFFER, //!< the check of a frame buffer object
        BUFFER,      //!< the memory of a buffer
        MAPPING,     //!< the mapping of a buffer
        QUERY        //!< the result of a query is 0
    };

    /** Let a call fail from now on, and watch those of a context, which is current.
     * @param call the number of the call of this kind that fails, from 0 on. */
    static void begin(osg::GraphicsContext& context, Kind kind, std::size_t call);
    /** The same, but every call of this kind fails. */
    static void beginAll(osg::GraphicsContext& context, Kind kind);
    /** The number of calls that have failed since begin() or beginAll(). */
    static std::size_t getNumFailed();
    /** Let no more calls fail. @return whether one has failed since begin(). */
    static bool end();
};

} // namespace osgLego::test
