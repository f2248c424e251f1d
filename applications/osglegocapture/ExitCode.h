#pragma once

#include <stdexcept>
#include <string>

namespace osgLego
{

/** The exit codes of osglegocapture. */
enum ExitCode : int
{
    EXIT_FINE = 0,
    EXIT_DIFFERENT = 1,   //!< --compare: the pictures differ by more than the tolerance
    EXIT_BAD_OPTIONS = 2, //!< a bad option or value
    EXIT_BAD_INPUT = 3,   //!< a missing or unreadable file, or one without triangles
    EXIT_BAD_OUTPUT = 4,  //!< a file that can't be written
    EXIT_NO_GL = 5        //!< no GL context that can make bricks
};

/** A failure: the exit code of the program, and one sentence that names the error and the expected value.
 */
class CaptureError : public std::runtime_error
{
public:
    CaptureError(ExitCode code, const std::string& message) : std::runtime_error(message), _code(code) {}

    ExitCode getCode() const { return _code; }

private:
    ExitCode _code;
};

} // namespace osgLego
