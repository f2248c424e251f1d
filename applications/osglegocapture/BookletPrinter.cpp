#include "BookletPrinter.h"

#include "CaptureFiles.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <fcntl.h>
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
        std::string name = (std::filesystem::temp_directory_path() / "osglego-XXXXXX").string();
        if (mkdtemp(name.data())) _path = name;
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

/** Copy a page with a size of paper, which Chromium takes from the style sheet. */
void copyWithPaper(const std::string& page, const std::filesystem::path& copy)
{
    std::ostringstream text;
    text << std::ifstream(page, std::ios::binary).rdbuf();
    std::string content = text.str();
    constexpr std::string_view STYLE = "<style>";
    if (const std::size_t style = content.find(STYLE); style != std::string::npos)
        content.insert(style + STYLE.size(), "@page { size: A4; }");
    std::ofstream(copy, std::ios::binary) << content;
}

/** Run a program without output. @return whether it has succeeded. */
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
    pid_t process = 0;
    const int failure = posix_spawn(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) return false;
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

std::string printBooklet(const std::string& page, const std::string& pdf)
{
    const std::string chromium = findChromium();
    if (chromium.empty()) return "Chromium is not installed; expected the package chromium";
    const TemporaryFolder temporary;
    if (temporary.getPath().empty()) return std::string("there is no temporary folder: ") + std::strerror(errno);
    const std::filesystem::path copy = temporary.getPath() / "page.html";
    const std::filesystem::path printed = temporary.getPath() / "page.pdf";
    copyWithPaper(page, copy);
    std::vector<std::string> command{chromium,
                                     "--headless",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--user-data-dir=" + (temporary.getPath() / "profile").string(),
                                     "--no-pdf-header-footer"};
    // Chromium's sandbox refuses to run as root.
    if (geteuid() == 0) command.emplace_back("--no-sandbox");
    command.push_back("--print-to-pdf=" + printed.string());
    command.push_back("file://" + copy.string());
    std::error_code error;
    if (!run(command) || std::filesystem::file_size(printed, error) == 0 || error) return "Chromium could not print it";
    writeText(pdf, [&](std::ostream& stream) { stream << std::ifstream(printed, std::ios::binary).rdbuf(); });
    return {};
}

} // namespace osgLego
