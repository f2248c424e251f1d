#include "SharedOptions.h"

#include <osgLego/LegoSettings.h>

namespace osgLego
{

void addResolutionOption(CLI::App& command, std::vector<unsigned int>& resolutions, const std::string& usual)
{
    command.add_option("--resolution", resolutions, "Cells along the longest side (" + usual + ")")
        ->delimiter(',')
        ->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION))
        ->type_name("N,...");
}

void addModelsOption(CLI::App& command, std::string& folder, const std::string& content)
{
    command.add_option("--models", folder, "The folder of " + content + " (build/models)")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
}

} // namespace osgLego
