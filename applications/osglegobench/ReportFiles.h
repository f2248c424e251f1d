#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

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
    /** Write those that are wanted, each completely or not at all. Throws std::runtime_error. */
    void write(const std::function<std::string()>& formatJson, const std::function<std::string()>& formatCsv) const;
};

} // namespace osgLego
