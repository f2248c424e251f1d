#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace osgLego
{

/** A subcommand and its options. Only BenchCommand.cpp includes the header of CLI11, which takes seconds to compile.
 * Options are written to the given variables when the command line is read; these must live until then. Help texts give
 * defaults in brackets. */
class BenchCommand
{
public:
    explicit BenchCommand(CLI::App& app) : _app(&app) {}

    void addFlag(const std::string& name, bool& value, const std::string& help);
    void addText(const std::string& name, std::string& value, const std::string& help, const std::string& type);
    /** An existing folder. */
    void addFolder(const std::string& name, std::string& value, const std::string& help);
    void addChoice(const std::string& name, std::string& value, const std::string& help,
                   const std::vector<std::string>& choices);
    /** Several texts, separated by spaces. */
    void addTexts(const std::string& name, std::vector<std::string>& values, const std::string& help,
                  const std::string& type);
    /** Several texts without commas, separated by commas. */
    void addNames(const std::string& name, std::vector<std::string>& values, const std::string& help);
    /** A number within limits; unsigned int, int or double. */
    template <typename Number>
    void addNumber(const std::string& name, Number& value, const std::string& help, Number least, Number most);
    /** Several numbers within limits, separated by commas. */
    void addNumbers(const std::string& name, std::vector<unsigned int>& values, const std::string& help,
                    unsigned int least, unsigned int most);
    /** Set the function that runs the command once its options have been read. */
    void setRun(const std::function<void()>& run);

private:
    CLI::App* _app;
};

/** The command line of a program with subcommands, of which each call names one. */
class BenchCommandLine
{
public:
    BenchCommandLine(const std::string& description, const std::string& program);
    ~BenchCommandLine();

    BenchCommand add(const std::string& name, const std::string& description);
    /** Read the options and run the command. @return the exit code. Passes on exceptions of the command. */
    int run(int argc, char** argv);

private:
    std::unique_ptr<CLI::App> _app;
};

} // namespace osgLego
