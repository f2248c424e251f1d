#pragma once

#include <string>

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
