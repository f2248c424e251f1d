#pragma once

#include <functional>
#include <ostream>

namespace osgLego
{

/** Keeps standard output for one text: while this lives, everything that the program and its libraries print there goes
 * to standard error. One at a time. */
class StandardOutput
{
public:
    StandardOutput();
    ~StandardOutput();
    StandardOutput(const StandardOutput&) = delete;
    StandardOutput& operator=(const StandardOutput&) = delete;

    /** Write the text. Throws CaptureError when it can't be written. */
    void write(const std::function<void(std::ostream&)>& write) const;

private:
    int _descriptor; // of standard output as it was
};

} // namespace osgLego
