#pragma once

namespace CLI
{
class App;
}

namespace osgLego
{

/** Throws CLI::ParseError if an argument is an option that does not exist, with the name of the one that is spelled
 * like it; or if it is --name= without a value, since CLI11 would take the next argument as the value.
 * @param app with all options. */
void checkArguments(const CLI::App& app, int argc, char** argv);

} // namespace osgLego
