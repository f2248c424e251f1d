#pragma once

namespace osgLego
{

/** The most memory of this process that was ever resident, in MiB. Throws std::runtime_error. */
double readPeakMemory();

/** From here on, the peak is what there is now. */
void resetPeakMemory();

} // namespace osgLego
