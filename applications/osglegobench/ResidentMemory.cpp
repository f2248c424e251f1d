#include "ResidentMemory.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace osgLego
{

double readPeakMemory()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
    throw std::runtime_error("/proc/self/status has no VmHWM");
}

void resetPeakMemory()
{
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace osgLego
