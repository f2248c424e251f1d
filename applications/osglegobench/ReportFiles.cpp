#include "ReportFiles.h"

#include <common/CompleteFile.h>

#include <stdexcept>

namespace osgLego
{

void ReportFiles::addTo(CLI::App& command)
{
    command.add_option("--json", jsonFile, "Write everything that was measured")->type_name("FILE");
    command.add_option("--csv", csvFile, "Write a line for each row that was measured")->type_name("FILE");
}

void ReportFiles::check() const
{
    checkPlace(jsonFile);
    checkPlace(csvFile);
    if (!jsonFile.empty() && !csvFile.empty() && isSameFile(jsonFile, csvFile))
        throw std::runtime_error("--json and --csv both name '" + csvFile + "'; allowed: a file each");
}

} // namespace osgLego
