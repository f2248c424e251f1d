#include <osgLego/gl/ShaderLibrary.h>

#include <osgLego/data/SharedObjects.h>
#include <osgLego/gl/ContextProgram.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include <osg/Notify>
#include <osg/Shader>

namespace osgLego
{

/** The embedded files by name; generated at build time, see CMakeLists.txt. */
const ShaderLibrary::Sources& getEmbeddedShaders();

namespace
{

constexpr const char* FOLDER_VARIABLE = "OSGLEGO_SHADER_PATH";
constexpr const char* VERSION_LINE = "#version 400 compatibility\n";
// Drivers may define both GL_core_profile and GL_compatibility_profile for either profile (GLSL 4.00, section 3.3).
constexpr const char* CORE_VERSION_LINE = "#version 400 core\n#define OSGLEGO_CORE_PROFILE\n";

bool readFile(const std::string& path, std::string& text)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) return false;
    std::ostringstream stream;
    stream << file.rdbuf();
    text = stream.str();
    return true;
}

/** The embedded files, and those given to ShaderLibrary::add(). */
class KnownSources
{
public:
    void add(const ShaderLibrary::Sources& sources)
    {
        const std::lock_guard lock(_mutex);
        _sources.insert(sources.begin(), sources.end());
    }

    bool find(const std::string& fileName, std::string& text) const
    {
        const std::lock_guard lock(_mutex);
        const auto place = _sources.find(fileName);
        if (place == _sources.end()) return false;
        text = place->second;
        return true;
    }

private:
    mutable std::mutex _mutex;
    ShaderLibrary::Sources _sources = getEmbeddedShaders();
};

std::atomic<ShaderLibrary::ProgramCallback> programCallback{nullptr};

KnownSources& getKnownSources()
{
    static KnownSources sources;
    return sources;
}

bool readShader(const std::string& fileName, std::string& text)
{
    if (const char* folder = std::getenv(FOLDER_VARIABLE))
        if (readFile(std::string(folder) + "/" + fileName, text)) return true;
    return getKnownSources().find(fileName, text);
}

/** Warn once: a program asks for its sources several times. */
void warnOnce(const std::string& warning)
{
    static std::mutex mutex;
    static std::set<std::string> given;
    const std::lock_guard lock(mutex);
    if (given.insert(warning).second) OSG_WARN << "osgLego: " << warning << std::endl;
}

/** Replaces lines that include files by these files. */
class IncludeResolver
{
public:
    /** @return the text of a file, with its includes resolved; empty, with a warning, if there is none, or it includes
     * itself. */
    std::string resolve(const std::string& fileName)
    {
        const std::string text = include(fileName);
        return _isCyclic ? std::string() : text;
    }

private:
    std::string include(const std::string& fileName)
    {
        if (const auto first = std::find(_open.begin(), _open.end(), fileName); first != _open.end())
        {
            _isCyclic = true;
            warnOfCycle({first, _open.end()});
            return {};
        }
        std::string text;
        if (!readShader(fileName, text))
        {
            warnOnce("shader '" + fileName + "' not found");
            return {};
        }
        _open.push_back(fileName);
        text = resolveLines(text);
        _open.pop_back();
        return text;
    }

    std::string resolveLines(const std::string& text)
    {
        constexpr std::string_view INCLUDE = "#include \"";
        std::ostringstream result;
        std::istringstream lines(text);
        for (std::string line; !_isCyclic && std::getline(lines, line);)
        {
            if (line.starts_with(INCLUDE))
                result << include(line.substr(INCLUDE.size(), line.rfind('"') - INCLUDE.size()));
            else
                result << line << '\n';
        }
        return result.str();
    }

    static void warnOfCycle(const std::vector<std::string>& cycle)
    {
        std::string names;
        for (const std::string& name : cycle)
            names += "'" + name + "' includes ";
        warnOnce(names + "'" + cycle.front() + "'; expected shaders that do not include themselves");
    }

    std::vector<std::string> _open; // the files that are being included, each by the one before
    bool _isCyclic = false;
};

osg::Shader::Type stageOf(const std::string& fileName)
{
    if (fileName.ends_with(".vert")) return osg::Shader::VERTEX;
    if (fileName.ends_with(".geom")) return osg::Shader::GEOMETRY;
    return osg::Shader::FRAGMENT;
}

/** The values that determine a program. */
struct ProgramKey
{
    std::string pass;
    std::string definitions;
    std::vector<std::string> fileNames;
    std::vector<std::string> captured;
    std::vector<std::string> sources; // empty if they are those of the library

    bool operator==(const ProgramKey&) const = default;
};

void setUp(ContextProgram& program, const ProgramKey& key, const char* versionLine)
{
    program.setName("osgLego::" + key.pass + " " + key.definitions);
    for (const std::string& fileName : key.fileNames)
    {
        osg::ref_ptr<osg::Shader> shader =
            new osg::Shader(stageOf(fileName), versionLine + key.definitions + ShaderLibrary::getSource(fileName));
        shader->setName("osgLego/" + fileName);
        program.addShader(shader);
    }
    for (const std::string& varying : key.captured)
        program.addTransformFeedBackVarying(varying);
    if (!key.captured.empty()) program.setTransformFeedBackMode(GL_INTERLEAVED_ATTRIBS);
    program.reserveContexts();
    if (const ShaderLibrary::ProgramCallback callback = programCallback) callback(program);
}

osg::ref_ptr<ContextProgram> createForCore(const ProgramKey& key)
{
    osg::ref_ptr<ContextProgram> program = new ContextProgram(nullptr);
    setUp(*program, key, CORE_VERSION_LINE);
    return program;
}

osg::ref_ptr<osg::Program> createProgram(const ProgramKey& key)
{
    osg::ref_ptr<ContextProgram> program = new ContextProgram([key] { return createForCore(key); });
    setUp(*program, key, VERSION_LINE);
    return program;
}

} // namespace

void ShaderLibrary::add(const Sources& sources)
{
    getKnownSources().add(sources);
}

std::string ShaderLibrary::getSource(const std::string& fileName)
{
    return IncludeResolver().resolve(fileName);
}

osg::ref_ptr<osg::Program> ShaderLibrary::getProgram(const std::string& pass,
                                                     std::initializer_list<const char*> fileNames,
                                                     const std::string& definitions,
                                                     const std::vector<const char*>& captured)
{
    static SharedObjects<ProgramKey, osg::Program> programs;
    ProgramKey key{pass, definitions, {fileNames.begin(), fileNames.end()}, {captured.begin(), captured.end()}, {}};
    // Files that can be edited must be read.
    if (std::getenv(FOLDER_VARIABLE))
        for (const std::string& fileName : key.fileNames)
            key.sources.push_back(getSource(fileName));
    return programs.findOrCreate(key, [&] { return createProgram(key); });
}

void ShaderLibrary::setProgramCallback(ProgramCallback callback)
{
    programCallback = callback;
}

} // namespace osgLego
