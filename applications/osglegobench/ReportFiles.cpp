#include "ReportFiles.h"

#include "BenchFiles.h"

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
}

void ReportFiles::write(const std::function<std::string()>& formatJson,
                        const std::function<std::string()>& formatCsv) const
{
    if (!jsonFile.empty()) writeTextFile(jsonFile, formatJson());
    if (!csvFile.empty()) writeTextFile(csvFile, formatCsv());
}

} // namespace osgLego
