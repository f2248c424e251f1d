#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include <osg/Program>
#include <osg/ref_ptr>

namespace osgLego
{

/** The GLSL sources of the passes, which are files of the folder shaders/, embedded in the library when it is built.
 *
 * When the environment variable OSGLEGO_SHADER_PATH names a folder, files are read from there instead, so that shaders
 * can be edited without building; a file that is missing there comes from the library. A line `#include "file"` is
 * replaced by that file. So can headers of C++ be, `#include "osgLego/NAME.h"`, which are written to suit both
 * languages; CMakeLists.txt lists them.
 *
 * Every function may be called from any thread.
 */
class ShaderLibrary
{
public:
    using Sources = std::map<std::string_view, std::string_view>;

    /** Make more files known, by their names: those of a program that draws with shaders of its own besides. The texts
     * must outlive every use of the library. */
    static void add(const Sources& sources);

    /** The text of a file of shaders/, its includes resolved; empty, with a warning, when there is none. */
    static std::string getSource(const std::string& fileName);

    /** A program of the given stages (.vert, .geom and .frag files).
     *
     * Its name is `pass` and the definitions together, since OSG takes programs that look alike for one.
     * @param definitions lines of GLSL, `#define NAME value`, put in front of every stage. */
    static osg::ref_ptr<osg::Program> createProgram(const std::string& pass,
                                                    std::initializer_list<const char*> fileNames,
                                                    const std::string& definitions = {});
};

} // namespace osgLego
