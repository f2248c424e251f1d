#pragma once

namespace osgLego
{

/** The peak of this process's resident memory (VmHWM), in MiB. Throws std::runtime_error. */
double readPeakMemory();

/** Reset the peak to the memory that is resident now. */
void resetPeakMemory();

} // namespace osgLego
