#pragma once

#include <functional>
#include <ostream>

namespace osgLego
{

/** Reserves standard output for one text: while this object exists, everything else that the program and its libraries
 * print to standard output is redirected to standard error. Only one object may exist at a time. */
class StandardOutput
{
public:
    StandardOutput();
    ~StandardOutput();
    StandardOutput(const StandardOutput&) = delete;
    StandardOutput& operator=(const StandardOutput&) = delete;

    /** Write the text. Throws CaptureError if it can't be written. */
    void write(const std::function<void(std::ostream&)>& write) const;

private:
    int _descriptor; // the original standard output
};

} // namespace osgLego
