#pragma once

#include <span>
#include <string_view>

/** A file format that Assimp reads and OpenSceneGraph 3.6 does not. */
struct AssimpFormat
{
    std::string_view extension;
    std::string_view name;
    bool isYUp; //!< whether Assimp gives models of this format with Y upwards
};

/** All formats that the plugin reads, sorted by extension. */
std::span<const AssimpFormat> getAssimpFormats();

/** The format of an extension in lower case; null if the plugin does not read it. */
const AssimpFormat* findAssimpFormat(std::string_view extension);
