#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace osgLego::test
{

/** Record every program that ShaderLibrary creates from now on. */
void watchPrograms();

bool hasValidator();

/** The errors that glslangValidator finds in programs recorded since the last call, except those that it has checked
 * before in this process, or that an earlier run has linked without errors. Each error names the folder with the stages
 * of the program. Without glslangValidator, nothing is checked. */
std::vector<std::string> takeProgramErrors();

/** Whether names are defined, by the names that `#if defined(NAME)` and `#ifdef NAME` test. */
using Conditions = std::map<std::string, std::set<bool>>;

/** The conditions in the stages of all recorded programs: { true, false } if both branches of a condition are used. */
Conditions getProgramConditions();

} // namespace osgLego::test
