#pragma once

#include "BenchFiles.h"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace osgLego
{

/** The options --json and --csv of a subcommand, and the files that they name. */
struct ReportFiles
{
    std::string jsonFile;
    std::string csvFile;

    void addTo(CLI::App& command);
    /** Throws std::runtime_error when one can't be written; for asking before hours of measuring. */
    void check() const;
    /** Print what was measured, and write the files that are wanted, each completely or not at all. Throws
     * std::runtime_error.
     * @param results what there are formatTables(), formatJson() and formatCsv() for. */
    template <typename Results>
    void report(const Results& results) const
    {
        fmt::print("{}", formatTables(results));
        if (!jsonFile.empty()) writeTextFile(jsonFile, formatJson(results));
        if (!csvFile.empty()) writeTextFile(csvFile, formatCsv(results));
    }
};

} // namespace osgLego
