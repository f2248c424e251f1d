#pragma once

#include <common/JsonValue.h>

#include <functional>

namespace osgLego
{

/** Measure something in a separate process, so that its first frame and its peak memory are its own. The calling
 * process must have a single thread and no GL context, since the new process is a copy of it.
 * @param measure returns the figures, or throws an exception.
 * @return the figures. Throws std::runtime_error with the message of the exception, or if the process crashes. */
JsonValue measureInSeparateProcess(const std::function<JsonValue()>& measure);

} // namespace osgLego
