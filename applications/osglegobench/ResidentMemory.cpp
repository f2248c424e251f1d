#include "ResidentMemory.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace osgLego
{

namespace
{

/** A figure of /proc/self/status, in MiB. @param name with its colon. */
double readStatus(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name)) return std::stod(line.substr(name.size())) / 1024.0;
    throw std::runtime_error("/proc/self/status has no " + name);
}

} // namespace

double readPeakMemory()
{
    return readStatus("VmHWM:");
}

double readResidentMemory()
{
    malloc_trim(0);
    return readStatus("VmRSS:");
}

double readHeapMemory()
{
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd) / (1024.0 * 1024.0);
}

void resetPeakMemory()
{
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace osgLego
