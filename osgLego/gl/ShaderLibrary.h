#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include <osg/Program>
#include <osg/ref_ptr>

namespace osgLego
{

/** The GLSL sources of the passes: the files of the folder shaders/, embedded in the library when it is built.
 *
 * If the environment variable OSGLEGO_SHADER_PATH names a folder, files are read from there instead, so that shaders
 * can be edited without a build; files missing there come from the library. A line `#include "file"` is replaced by
 * that file. Shaders may also include C++ headers that are valid in both languages, as `#include "osgLego/NAME.h"`;
 * CMakeLists.txt lists them.
 *
 * Every function may be called from any thread.
 */
class ShaderLibrary
{
public:
    using Sources = std::map<std::string_view, std::string_view>;

    /** Add files by name, for a program that adds its own shaders. The texts must outlive every use of
     * the library. */
    static void add(const Sources& sources);

    /** The text of a file in shaders/, with its includes resolved; empty, with a warning, if there is no such file. */
    static std::string getSource(const std::string& fileName);

    /** A program of the given stages (.vert, .geom and .frag files).
     *
     * Its name combines `pass` and the definitions, since OSG may merge programs that look alike.
     * @param definitions lines of GLSL, `#define NAME value`, put at the start of every stage. */
    static osg::ref_ptr<osg::Program> createProgram(const std::string& pass,
                                                    std::initializer_list<const char*> fileNames,
                                                    const std::string& definitions = {});

    using ProgramCallback = void (*)(const osg::Program& program);
    /** Set a function that receives each program that createProgram() creates, in the calling thread; null for none.
     * Tests use it to check every program that the library creates. */
    static void setProgramCallback(ProgramCallback callback);
};

} // namespace osgLego
