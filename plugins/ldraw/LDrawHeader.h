#pragma once

#include <string>

#include <osgDB/Options>

namespace osgLego
{

/** The texts at the beginning of a file that its author chooses.
 *
 * A program sets them as plugin data of osgDB::Options, TITLE, AUTHOR and LICENSE, and a command line in the string of
 * options: osgconv -O 'author="Ann Smith" license="Licensed under CC BY 4.0 : see CAreadme.txt"'. */
struct LDrawHeader
{
    std::string title; //!< empty: the readable name of the model
    std::string author = "osgLego";
    std::string license; //!< the text after !LICENSE; empty: no such line

    /** @param options may be null. */
    static LDrawHeader read(const osgDB::Options* options);
};

} // namespace osgLego
