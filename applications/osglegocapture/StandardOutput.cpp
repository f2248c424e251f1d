#include "StandardOutput.h"

#include "ExitCode.h"

#include <common/DescriptorBuffer.h>

#include <cstdio>
#include <cstring>
#include <string>

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
    std::clearerr(stdout); // messages that can't be written to standard error are lost
    dup2(_descriptor, STDOUT_FILENO);
    close(_descriptor);
}

void StandardOutput::write(const std::function<void(std::ostream&)>& write) const
{
    DescriptorBuffer buffer(_descriptor);
    std::ostream stream(&buffer);
    write(stream);
    stream.flush();
    if (buffer.getError() != 0 || !stream)
        throw CaptureError(EXIT_BAD_OUTPUT,
                           std::string("can't write to standard output: ") + std::strerror(buffer.getError()));
}

} // namespace osgLego
