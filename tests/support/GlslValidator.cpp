#include "GlslValidator.h"

#include <common/CompleteFile.h>
#include <osgLego/gl/ShaderLibrary.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <utility>

#include <osg/Program>

namespace osgLego::test
{

namespace
{

/** The stages of a program by the names of the files that glslangValidator expects. */
using Stages = std::map<std::string, std::string>;

/** The names that a stage tests with #ifdef, #ifndef or defined(), except those of GL, the profile and the guards of
 * headers. */
std::set<std::string> findConditions(const std::string& text)
{
    std::set<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        for (const char* start : {"#ifdef ", "#ifndef ", "#if defined(", "#if !defined("})
        {
            if (!line.starts_with(start)) continue;
            std::string name = line.substr(std::strlen(start));
            name = name.substr(0, name.find_first_of(") "));
            if (!name.starts_with("GL_") && !name.starts_with("OSGLEGO_") && !name.starts_with("__"))
                names.insert(name);
        }
    return names;
}

class ProgramRecord
{
public:
    static ProgramRecord& get()
    {
        static ProgramRecord record;
        return record;
    }

    /** Called from any thread. */
    void add(const osg::Program& program)
    {
        Stages stages;
        for (unsigned int index = 0; index < program.getNumShaders(); ++index)
        {
            const osg::Shader& shader = *program.getShader(index);
            stages[std::string("stage.") + extensionOf(shader)] = shader.getShaderSource();
        }
        const std::lock_guard lock(_mutex);
        if (_known.insert(stages).second) _unchecked.emplace_back(program.getName(), stages);
    }

    std::vector<std::pair<std::string, Stages>> takeUnchecked()
    {
        const std::lock_guard lock(_mutex);
        return std::exchange(_unchecked, {});
    }

    Conditions getConditions()
    {
        const std::lock_guard lock(_mutex);
        Conditions conditions;
        for (const Stages& stages : _known)
            for (const auto& [file, text] : stages)
                for (const std::string& name : findConditions(text))
                    conditions[name].insert(text.find("\n#define " + name + "\n") != std::string::npos);
        return conditions;
    }

private:
    static const char* extensionOf(const osg::Shader& shader)
    {
        if (shader.getType() == osg::Shader::VERTEX) return "vert";
        return shader.getType() == osg::Shader::GEOMETRY ? "geom" : "frag";
    }

    std::mutex _mutex;
    std::set<Stages> _known;
    std::vector<std::pair<std::string, Stages>> _unchecked;
};

/** Run a command. @return whether it succeeds. */
bool run(const std::string& command, std::string& output)
{
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return false;
    std::array<char, 4096> buffer{};
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe))
        output += buffer.data();
    return pclose(pipe) == 0;
}

/** The folder of a program, which keeps its stages for the reader of an error. Programs with the same stages share it.
 */
std::filesystem::path folderOf(const Stages& stages)
{
    std::string all;
    for (const auto& [name, text] : stages)
        all += name + '\n' + text;
    return std::filesystem::path(OSGLEGO_TEST_PROGRAMS) / std::to_string(std::hash<std::string>()(all));
}

/** Link a program with glslangValidator, unless an earlier run, in any process, has linked it without errors.
 * @return its messages and the folder with the stages; empty if there are none. */
std::string check(const Stages& stages)
{
    const std::filesystem::path folder = folderOf(stages);
    // A later version of the validator checks again.
    const auto version = std::filesystem::last_write_time(OSGLEGO_GLSLANG_VALIDATOR).time_since_epoch().count();
    const std::filesystem::path mark = folder / ("linked-" + std::to_string(version));
    if (std::filesystem::exists(mark)) return {};
    std::filesystem::create_directories(folder);
    std::string command = "'" OSGLEGO_GLSLANG_VALIDATOR "' -l";
    for (const auto& [name, text] : stages)
    {
        const std::string file = (folder / name).string();
        // Atomically, since another process may be checking the same program.
        if (const std::string error =
                writeCompleteFile(file, [&text = text](std::ostream& stream) { return stream << text, std::string(); });
            !error.empty())
            return error;
        command += " '" + file + "'";
    }
    std::string output;
    if (!run(command, output)) return output + "in " + folder.string();
    std::ofstream{mark};
    return {};
}

} // namespace

void watchPrograms()
{
    ShaderLibrary::setProgramCallback([](const osg::Program& program) { ProgramRecord::get().add(program); });
}

bool hasValidator()
{
    return std::filesystem::exists(OSGLEGO_GLSLANG_VALIDATOR);
}

std::vector<std::string> takeProgramErrors()
{
    std::vector<std::string> errors;
    if (!hasValidator()) return errors;
    for (const auto& [name, stages] : ProgramRecord::get().takeUnchecked())
        if (const std::string error = check(stages); !error.empty()) errors.push_back(name + ": " + error);
    return errors;
}

Conditions getProgramConditions()
{
    return ProgramRecord::get().getConditions();
}

} // namespace osgLego::test
