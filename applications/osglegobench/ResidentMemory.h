#pragma once

namespace osgLego
{

/** The peak of this process's resident memory (VmHWM), in MiB. Throws std::runtime_error. */
double readPeakMemory();

/** The resident memory of this process (VmRSS) without memory that was freed, in MiB. Throws std::runtime_error. */
double readResidentMemory();

/** The bytes that this process has allocated from the heap and not freed, in MiB. */
double readHeapMemory();

/** Reset the peak to the memory that is resident now. */
void resetPeakMemory();

} // namespace osgLego
