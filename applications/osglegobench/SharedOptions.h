#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace osgLego
{

// Options that several subcommands have.

/** --resolution N,... @param usual what is measured without it, as --help says it. */
void addResolutionOption(CLI::App& command, std::vector<unsigned int>& resolutions, const std::string& usual);

/** --models FOLDER, which must be there. @param content what lies in it, as --help says it. */
void addModelsOption(CLI::App& command, std::string& folder, const std::string& content);

} // namespace osgLego
