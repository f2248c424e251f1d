#include "BenchCommand.h"

#include <CLI/CLI.hpp>

namespace osgLego
{

void BenchCommand::addFlag(const std::string& name, bool& value, const std::string& help)
{
    _app->add_flag(name, value, help);
}

void BenchCommand::addText(const std::string& name, std::string& value, const std::string& help,
                           const std::string& type)
{
    _app->add_option(name, value, help)->type_name(type);
}

void BenchCommand::addFolder(const std::string& name, std::string& value, const std::string& help)
{
    _app->add_option(name, value, help)->type_name("FOLDER")->check(CLI::ExistingDirectory);
}

void BenchCommand::addChoice(const std::string& name, std::string& value, const std::string& help,
                             const std::vector<std::string>& choices)
{
    _app->add_option(name, value, help)->check(CLI::IsMember(choices));
}

void BenchCommand::addTexts(const std::string& name, std::vector<std::string>& values, const std::string& help,
                            const std::string& type)
{
    _app->add_option(name, values, help)->type_name(type);
}

void BenchCommand::addNames(const std::string& name, std::vector<std::string>& values, const std::string& help)
{
    _app->add_option(name, values, help)->delimiter(',')->type_name("NAME,...");
}

template <typename Number>
void BenchCommand::addNumber(const std::string& name, Number& value, const std::string& help, Number least, Number most)
{
    _app->add_option(name, value, help)->check(CLI::Range(least, most));
}

template void BenchCommand::addNumber(const std::string&, unsigned int&, const std::string&, unsigned int,
                                      unsigned int);
template void BenchCommand::addNumber(const std::string&, int&, const std::string&, int, int);
template void BenchCommand::addNumber(const std::string&, double&, const std::string&, double, double);

void BenchCommand::addNumbers(const std::string& name, std::vector<unsigned int>& values, const std::string& help,
                              unsigned int least, unsigned int most)
{
    _app->add_option(name, values, help)->delimiter(',')->check(CLI::Range(least, most))->type_name("N,...");
}

void BenchCommand::setRun(const std::function<void()>& run)
{
    _app->callback(run);
}

BenchCommandLine::BenchCommandLine(const std::string& description, const std::string& program) :
    _app(std::make_unique<CLI::App>(description, program))
{
    _app->require_subcommand(1);
}

BenchCommandLine::~BenchCommandLine() = default;

BenchCommand BenchCommandLine::add(const std::string& name, const std::string& description)
{
    return BenchCommand(*_app->add_subcommand(name, description));
}

int BenchCommandLine::run(int argc, char** argv)
{
    CLI11_PARSE(*_app, argc, argv);
    return 0;
}

} // namespace osgLego
