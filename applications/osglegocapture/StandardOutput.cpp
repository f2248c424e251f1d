#include "StandardOutput.h"

#include "ExitCode.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace osgLego
{

StandardOutput::StandardOutput()
{
    std::fflush(stdout);
    _descriptor = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
}

StandardOutput::~StandardOutput()
{
    std::fflush(stdout);
    dup2(_descriptor, STDOUT_FILENO);
    close(_descriptor);
}

void StandardOutput::write(const std::function<void(std::ostream&)>& write) const
{
    std::ostringstream stream;
    write(stream);
    const std::string text = stream.str();
    for (std::string_view rest = text; !rest.empty();)
    {
        const ssize_t count = ::write(_descriptor, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            throw CaptureError(EXIT_BAD_OUTPUT, std::string("can't write to standard output: ") + std::strerror(errno));
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
}

} // namespace osgLego
