#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

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

    /** The text of a file in shaders/, with its includes resolved; empty if there is no such file, or one includes
     * itself, with a warning that is given once. */
    static std::string getSource(const std::string& fileName);

    /** The program of the given stages (.vert, .geom and .frag files). Calls with equal arguments return the same
     * program for as long as it is in use, so that many nodes compile it once; do not change it.
     *
     * Its name combines `pass` and the definitions, since OSG may merge programs that look alike.
     * @param definitions lines of GLSL, `#define NAME value`, put at the start of every stage.
     * @param captured the varyings that transform feedback writes, interleaved into one buffer. */
    static osg::ref_ptr<osg::Program> getProgram(const std::string& pass, std::initializer_list<const char*> fileNames,
                                                 const std::string& definitions = {},
                                                 const std::vector<const char*>& captured = {});

    using ProgramCallback = void (*)(const osg::Program& program);
    /** Set a function that receives each program that getProgram() creates, in the calling thread; null for none.
     * Tests use it to check every program that the library creates. */
    static void setProgramCallback(ProgramCallback callback);
};

} // namespace osgLego
