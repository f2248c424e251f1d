#include "SeparateProcess.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

[[noreturn]] void fail(const char* function)
{
    throw std::runtime_error(std::string(function) + ": " + std::strerror(errno));
}

/** Write the figures, or the reason why there are none, and end the process. */
[[noreturn]] void report(int pipe, const std::function<JsonValue()>& measure)
{
    JsonValue answer = JsonValue::createObject();
    try
    {
        answer["figures"] = measure();
    }
    catch (const std::exception& error)
    {
        answer["error"] = error.what();
    }
    const std::string text = answer.toString();
    std::size_t written = 0;
    while (written < text.size())
    {
        const ssize_t count = write(pipe, text.data() + written, text.size() - written);
        if (count <= 0) break;
        written += static_cast<std::size_t>(count);
    }
    std::fflush(nullptr);
    _exit(0); // without the destructors of objects that belong to the other process
}

std::string readAll(int pipe)
{
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = read(pipe, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(count));
    return text;
}

} // namespace

JsonValue measureInSeparateProcess(const std::function<JsonValue()>& measure)
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) fail("pipe");
    std::fflush(nullptr); // or both processes would write the buffered output
    const pid_t process = fork();
    if (process < 0) fail("fork");
    if (process == 0)
    {
        close(ends[0]);
        report(ends[1], measure);
    }
    close(ends[1]);
    const std::string text = readAll(ends[0]);
    close(ends[0]);
    waitpid(process, nullptr, 0);
    const std::optional<JsonValue> answer = JsonValue::parse(text);
    if (!answer) throw std::runtime_error("the process that measures has crashed");
    if (answer->contains("error")) throw std::runtime_error((*answer)["error"].toText());
    return (*answer)["figures"];
}

} // namespace osgLego
