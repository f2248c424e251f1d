#pragma once

#include <common/ModelHeader.h>

#include <osgDB/Options>

namespace osgLego
{

/** The texts for the beginning of a written file.
 *
 * A program sets them as plugin data of osgDB::Options, TITLE, AUTHOR and LICENSE, and a command line in the string of
 * options: osgconv -O 'author="Ann Smith" license="Licensed under CC BY 4.0 : see CAreadme.txt"'.
 * @param options may be null. */
ModelHeader readLDrawHeader(const osgDB::Options* options);

} // namespace osgLego
