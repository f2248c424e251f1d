#pragma once

namespace osgLego
{

/** Have the libraries that this program uses work without threads of their own if the system can't start enough, as
 * with a low limit of processes or of memory. Otherwise, oneTBB and OpenImageIO throw exceptions in the middle of their
 * work, and Mesa waits indefinitely for threads that it could not start.
 *
 * Called once, before any of them is used. */
void adaptToThreadSupply();

} // namespace osgLego
