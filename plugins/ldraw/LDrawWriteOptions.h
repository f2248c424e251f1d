#pragma once

#include <common/ModelHeader.h>

#include <optional>
#include <string>

#include <osgDB/Options>

namespace osgLego
{

/** The choices of who writes a file. */
struct LDrawWriteOptions
{
    ModelHeader header;     //!< its texts replace those of the models
    bool isOnPlate = false; //!< whether each model stands on a base plate

    /** A program sets them as plugin data of osgDB::Options, TITLE, AUTHOR, LICENSE and BASE, which is "plate", and a
     * command line in the string of options: osgconv -O 'author="Ann Smith" base=plate'.
     * @param options may be null. @return nothing, with one sentence in `error`, if there is another base. */
    static std::optional<LDrawWriteOptions> read(const osgDB::Options* options, std::string& error);
};

} // namespace osgLego
