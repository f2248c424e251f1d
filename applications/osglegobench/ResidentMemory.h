#pragma once

namespace osgLego
{

/** The peak of this process's resident memory (VmHWM), in MiB. Throws std::runtime_error. */
double readPeakMemory();

/** Let the peak begin anew at the memory resident now. */
void resetPeakMemory();

} // namespace osgLego
