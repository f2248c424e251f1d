#pragma once

#include <string>

/** What a file name that ends in `.legolize` says: the file below it, and settings.
 *
 *     bunny.ply.legolize                   bunny.ply
 *     bunny.ply.64.legolize                bunny.ply, "64"
 *     bunny.ply.(64,edge=0.5).legolize     bunny.ply, "64,edge=0.5"
 *     sample.64.legolize                   sample, "64"
 *     sample.(probe=my.park(2).exr).legolize   sample, "probe=my.park(2).exr"
 *
 * The part before `.legolize` is settings when it stands in brackets, is a number, or holds an equals sign. Within
 * brackets there may be dots, slashes, spaces, and brackets that are closed again.
 */
struct LegolizeName
{
    std::string fileName;
    std::string settings;

    /** Take a name apart; false when it does not end in `.legolize`, or has nothing before that. */
    static bool parse(const std::string& name, LegolizeName& result);
};

/** The settings among the options of a reader (`-O "64,proportions=plate noRotation"`), and the rest, which is meant
 * for the reader of the file below.
 *
 * Options are separated by spaces; one is settings when it begins with a number or with a key of LegolizeSettings.
 * A file name in it can have neither spaces nor commas. */
struct LegolizeOptions
{
    std::string settings; //!< separated by commas
    std::string rest;     //!< separated by spaces

    static LegolizeOptions parse(const std::string& options);
};
