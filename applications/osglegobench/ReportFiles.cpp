#include "ReportFiles.h"

#include "BenchFiles.h"

#include <filesystem>
#include <stdexcept>

namespace osgLego
{

namespace
{

std::filesystem::path findPlace(const std::string& fileName)
{
    return std::filesystem::weakly_canonical(std::filesystem::absolute(fileName));
}

} // namespace

void ReportFiles::addTo(CLI::App& command)
{
    command.add_option("--json", jsonFile, "Write everything that was measured")->type_name("FILE");
    command.add_option("--csv", csvFile, "Write a line for each row that was measured")->type_name("FILE");
}

void ReportFiles::check() const
{
    checkPlace(jsonFile);
    checkPlace(csvFile);
    if (!jsonFile.empty() && !csvFile.empty() && findPlace(jsonFile) == findPlace(csvFile))
        throw std::runtime_error("--json and --csv both name '" + csvFile + "'; allowed: a file each");
}

void ReportFiles::write(const std::function<std::string()>& formatJson,
                        const std::function<std::string()>& formatCsv) const
{
    if (!jsonFile.empty()) writeTextFile(jsonFile, formatJson());
    if (!csvFile.empty()) writeTextFile(csvFile, formatCsv());
}

} // namespace osgLego
