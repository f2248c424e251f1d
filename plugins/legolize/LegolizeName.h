#pragma once

#include <string>

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

    /** An error message if there is an unmatched bracket in the last part of a path, otherwise empty. Files may have
     * such names, so call this only if the file doesn't exist. */
    static std::string findLoneBracket(const std::string& name);
};

/** The options of a reader (`-O "64,proportions=plate noRotation"`), split into settings and the rest, which is for the
 * reader of the model file.
 *
 * Options are separated by spaces. An option contains settings if it begins with a number or with a key of
 * LegolizeSettings. File names in it can contain neither spaces nor commas. */
struct LegolizeOptions
{
    std::string settings; //!< separated by commas
    std::string rest;     //!< separated by spaces

    static LegolizeOptions parse(const std::string& options);
};
