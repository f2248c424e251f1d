#include "BookletPrinter.h"

#include "Cancellation.h"
#include "CaptureFiles.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

/** A folder that is removed with all files in it. */
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::error_code error;
        std::string name = (std::filesystem::temp_directory_path(error) / "osglego-XXXXXX").string();
        if (!error && mkdtemp(name.data())) _path = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        if (!_path.empty()) std::filesystem::remove_all(_path, ignored);
    }

    /** Empty if the folder could not be created. */
    const std::filesystem::path& getPath() const { return _path; }

private:
    std::filesystem::path _path;
};

/** The path of Chromium or a browser with the same options; empty if there is none. */
std::string findChromium()
{
    const char* folders = std::getenv("PATH");
    std::istringstream list(folders ? folders : "");
    for (std::string folder; std::getline(list, folder, ':');)
        for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
            if (const std::string path = folder + "/" + name; access(path.c_str(), X_OK) == 0) return path;
    return {};
}

/** The address of a file. @param path absolute. */
std::string toAddress(const std::filesystem::path& path)
{
    constexpr std::string_view PLAIN = "/-._~0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    std::string address = "file://";
    for (const char character : path.string())
        address += PLAIN.find(character) != std::string_view::npos
                       ? std::string(1, character)
                       : fmt::format("%{:02X}", static_cast<unsigned char>(character));
    return address;
}

/** Copy a page with a size of paper, which Chromium takes from the style sheet. @return whether that has succeeded. */
bool copyWithPaper(const std::string& page, const std::filesystem::path& copy)
{
    std::ostringstream text;
    text << std::ifstream(page, std::ios::binary).rdbuf();
    if (!text) return false;
    std::string content = text.str();
    // The page allows its own style sheet by its hash.
    constexpr std::string_view POLICY = "<meta http-equiv=\"Content-Security-Policy\"";
    if (const std::size_t policy = content.find(POLICY); policy != std::string::npos)
        content.erase(policy, content.find('>', policy) + 1 - policy);
    constexpr std::string_view STYLE = "<style>";
    if (const std::size_t style = content.find(STYLE); style != std::string::npos)
        content.insert(style + STYLE.size(), "@page { size: A4 landscape; }");
    std::ofstream file(copy, std::ios::binary);
    file << content;
    file.close();
    return bool(file);
}

/** Wait until a program ends, or end it and its children if a signal has arrived. @return whether it has succeeded. */
bool waitFor(pid_t process)
{
    constexpr std::chrono::milliseconds INTERVAL(50);
    int status = 0;
    for (pid_t ended = 0; ended != process;)
    {
        ended = waitpid(process, &status, WNOHANG);
        if (ended < 0 && errno != EINTR) return false;
        if (ended != 0) continue;
        if (Cancellation::isRequested()) kill(-process, SIGKILL);
        std::this_thread::sleep_for(INTERVAL);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/** Run a program without output, in a process group of its own. @return whether it has succeeded. */
bool run(const std::vector<std::string>& command)
{
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str())); // posix_spawn() does not change them
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t ignored; // by this program only
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &ignored);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    pid_t process = 0;
    const int failure = posix_spawn(&process, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return failure == 0 && waitFor(process);
}

} // namespace

std::string printBooklet(const std::string& page, const std::string& pdf)
{
    const std::string chromium = findChromium();
    if (chromium.empty()) return "Chromium is not installed; expected the package chromium";
    const TemporaryFolder temporary;
    if (temporary.getPath().empty()) return "there is no temporary folder; expected one in TMPDIR or /tmp";
    const std::filesystem::path copy = temporary.getPath() / "page.html";
    const std::filesystem::path printed = temporary.getPath() / "page.pdf";
    if (!copyWithPaper(page, copy)) return "the temporary folder can't be written";
    std::vector<std::string> command{chromium,
                                     "--headless",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--user-data-dir=" + (temporary.getPath() / "profile").string(),
                                     "--no-pdf-header-footer"};
    // Chromium's sandbox refuses to run as root.
    if (geteuid() == 0) command.emplace_back("--no-sandbox");
    command.push_back("--print-to-pdf=" + printed.string());
    command.push_back(toAddress(copy));
    std::error_code error;
    const bool isRun = run(command);
    Cancellation::check("cancelled; the booklet was not printed");
    if (!isRun || std::filesystem::file_size(printed, error) == 0 || error) return "Chromium could not print it";
    writeText(pdf, [&](std::ostream& stream) { stream << std::ifstream(printed, std::ios::binary).rdbuf(); });
    return {};
}

} // namespace osgLego
