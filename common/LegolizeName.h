#pragma once

#include <string>

namespace osgLego
{

/** A file name that ends in `.legolize`, split into the name of the model file and settings.
 *
 *     bunny.ply.legolize                   bunny.ply
 *     bunny.ply.64.legolize                bunny.ply, "64"
 *     bunny.ply.(64,edge=0.5).legolize     bunny.ply, "64,edge=0.5"
 *     sample.64.legolize                   sample, "64"
 *     sample.(probe=my.park(2).exr).legolize   sample, "probe=my.park(2).exr"
 *
 * The part before `.legolize` contains settings if it is in brackets, is a number, or contains an equals sign. Brackets
 * may contain dots, slashes, spaces, and nested brackets.
 */
struct LegolizeName
{
    std::string fileName;
    std::string settings;

    /** Parse a name. Returns false if it does not end in `.legolize` or has nothing before that. */
    static bool parse(const std::string& name, LegolizeName& result);

    /** The name of the model file without its pseudo-loaders: `.legolize`, and those of OSG that turn, scale and move
     * models, such as "mug.ply" for "mug.ply.90,0,0.rot.64.legolize". */
    static std::string stripPseudoLoaders(const std::string& name);

    /** An error message if there is an unmatched bracket in the last part of a path, otherwise empty. Files may have
     * such names, so call this only if the file doesn't exist. */
    static std::string findLoneBracket(const std::string& name);
};

} // namespace osgLego
