#include <osgLego/ShaderLibrary.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include <osg/Notify>
#include <osg/Shader>

namespace osgLego
{

/** The embedded files by name; made at build time, see CMakeLists.txt. */
const std::map<std::string_view, std::string_view>& getEmbeddedShaders();

namespace
{

constexpr const char* VERSION_LINE = "#version 400 compatibility\n";

bool readFile(const std::string& path, std::string& text)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) return false;
    std::ostringstream stream;
    stream << file.rdbuf();
    text = stream.str();
    return true;
}

bool readShader(const std::string& fileName, std::string& text)
{
    if (const char* folder = std::getenv("OSGLEGO_SHADER_PATH"))
        if (readFile(std::string(folder) + "/" + fileName, text)) return true;
    const auto& shaders = getEmbeddedShaders();
    const auto place = shaders.find(fileName);
    if (place == shaders.end()) return false;
    text = place->second;
    return true;
}

osg::Shader::Type stageOf(const std::string& fileName)
{
    if (fileName.ends_with(".vert")) return osg::Shader::VERTEX;
    if (fileName.ends_with(".geom")) return osg::Shader::GEOMETRY;
    return osg::Shader::FRAGMENT;
}

} // namespace

std::string ShaderLibrary::getSource(const std::string& fileName)
{
    std::string text;
    if (!readShader(fileName, text))
    {
        OSG_WARN << "osgLego: there is no shader '" << fileName << "'" << std::endl;
        return {};
    }

    constexpr std::string_view INCLUDE = "#include \"";
    std::ostringstream result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        if (line.starts_with(INCLUDE))
            result << getSource(line.substr(INCLUDE.size(), line.rfind('"') - INCLUDE.size()));
        else
            result << line << '\n';
    }
    return result.str();
}

osg::ref_ptr<osg::Program> ShaderLibrary::createProgram(const std::string& pass,
                                                        std::initializer_list<const char*> fileNames,
                                                        const std::string& definitions)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("osgLego::" + pass + " " + definitions);
    for (const std::string fileName : fileNames)
    {
        osg::ref_ptr<osg::Shader> shader =
            new osg::Shader(stageOf(fileName), VERSION_LINE + definitions + getSource(fileName));
        shader->setName("osgLego/" + fileName);
        program->addShader(shader);
    }
    return program;
}

} // namespace osgLego
