#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

std::string withoutComments(const std::string& source)
{
    return std::regex_replace(source, std::regex("//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/"), "");
}

std::vector<std::string> findMatches(const std::string& text, const char* pattern)
{
    const std::regex expression(pattern);
    std::vector<std::string> matches;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        matches.push_back(match->str());
    return matches;
}

/** The declarations of booleans as members of structures and blocks, and as variables between stages: drivers that
 * translate GLSL to SPIR-V, such as Mesa's zink, make invalid types of them. */
std::vector<std::string> findBooleanMembers(const std::string& source)
{
    constexpr const char* BOOLEAN = R"(\b(bool|bvec[234])\s+[^;]*;)";
    const std::string text = withoutComments(source);
    std::vector<std::string> found =
        findMatches(text, R"(\b(in|out|varying|attribute)\s+(bool|bvec[234])\s+\w+\s*(\[[^\]]*\]\s*)?;)");
    for (const std::string& body :
         findMatches(text, R"((\bstruct(\s+\w+)?|\b(in|out|uniform|buffer)\s+\w+)\s*\{[^}]*\})"))
        for (const std::string& member : findMatches(body, BOOLEAN))
            found.push_back(member);
    return found;
}

std::vector<std::filesystem::path> findShaders()
{
    std::vector<std::filesystem::path> shaders;
    for (const char* folder :
         {"shaders", "applications/osglegobench/shaders", "applications/osglegobench/baselines/shaders"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(std::filesystem::path(OSGLEGO_SOURCE_FOLDER) / folder))
            if (entry.is_regular_file()) shaders.push_back(entry.path());
    return shaders;
}

std::string read(const std::filesystem::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/** The components of all outputs of a geometry shader's vertex with every option, and the position. Drivers turn
 * gl_ClipVertex into eight distances. */
int countOutputs(const std::string& source)
{
    const std::string text = withoutComments(source);
    int count = 4;
    for (const std::string& declaration : findMatches(text, R"((^|\n|;)\s*(flat\s+)?out\s+\w+\s+\w+\s*(\[\d+\])?\s*;)"))
    {
        std::smatch parts;
        std::regex_search(declaration, parts, std::regex(R"(out\s+[a-z]+(\d?)\s+\w+\s*(\[(\d+)\])?)"));
        const int components = parts[1].length() > 0 ? std::stoi(parts[1]) : 1;
        count += components * (parts[3].matched ? std::stoi(parts[3]) : 1);
    }
    const bool hasDistances = text.find("gl_ClipDistance[8]") != std::string::npos;
    return count + (text.find("gl_ClipVertex") != std::string::npos && !hasDistances ? 8 : 0);
}

/** The most vertices of a geometry shader with any option; 0 if another file determines their number. */
int countVertices(const std::string& source)
{
    int most = 0;
    for (const std::string& match : findMatches(withoutComments(source), R"(max_vertices\s*=\s*\d+)"))
        most = std::max(most, std::stoi(match.substr(match.find('=') + 1)));
    return most;
}

TEST(ShaderTypes, BooleansAreFoundInStructuresAndBlocksAndBetweenStagesOnly)
{
    using Texts = std::vector<std::string>;
    EXPECT_EQ(findBooleanMembers("struct Face\n{\n    vec2 place; // bool\n    bool isTop;\n    bvec2 sides[3];\n};\n"),
              Texts({"bool isTop;", "bvec2 sides[3];"}));
    EXPECT_EQ(findBooleanMembers("layout(std140) uniform Look { int a; bool b; } look;"), Texts({"bool b;"}));
    EXPECT_EQ(findBooleanMembers("struct { bool a; } face;"), Texts({"bool a;"}));
    EXPECT_EQ(findBooleanMembers("in Stage\n{\n    bool a;\n} stage[];"), Texts({"bool a;"}));
    EXPECT_EQ(findBooleanMembers("flat out bool isTop;\nin bvec3 sides[];\n"),
              Texts({"out bool isTop;", "in bvec3 sides[];"}));
    EXPECT_EQ(findBooleanMembers("uniform bool isOn;\n/* struct A { bool a; }; */\nbool f(in bool a, out bool b)\n{\n"
                                 "    bool c = a;\n    return c;\n}\nstruct Face { int isTop; };\n"),
              Texts());
}

TEST(ShaderTypes, NoStructureOrBlockHasBooleans)
{
    const std::vector<std::filesystem::path> shaders = findShaders();
    EXPECT_GT(shaders.size(), 50u);
    for (const std::filesystem::path& shader : shaders)
    {
        const std::string source = read(shader);
        EXPECT_FALSE(source.empty()) << shader;
        EXPECT_EQ(findBooleanMembers(source), std::vector<std::string>()) << shader << ": expected int";
    }
}

TEST(ShaderTypes, OutputsOfVerticesAreCounted)
{
    EXPECT_EQ(countOutputs("out vec3 a;\nflat out uint b; // out vec4 c;\nout float gl_ClipDistance[8];\n"),
              4 + 3 + 1 + 8);
    EXPECT_EQ(countOutputs("out uvec2 a;\nvoid f(out vec3 b) { gl_ClipVertex = c; }\n"), 4 + 2 + 8);
    EXPECT_EQ(countVertices("layout(points, max_vertices = 16) out;\nlayout(points, max_vertices = 8) out;"), 16);
}

// NVIDIA's driver links a program that exceeds the limit, and then nothing is drawn in its context any more.
TEST(ShaderTypes, GeometryShadersEmitNoMoreComponentsThanGlGuarantees)
{
    constexpr int LIMIT = 1024; // the least GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS
    int numShaders = 0;
    for (const std::filesystem::path& shader : findShaders())
    {
        if (shader.extension() != ".geom") continue;
        const std::string source = read(shader);
        const int vertices = countVertices(source);
        EXPECT_LE(vertices * countOutputs(source), LIMIT) << shader << ": " << vertices << " vertices";
        if (vertices > 0) ++numShaders;
    }
    EXPECT_GE(numShaders, 6);
}

} // namespace

} // namespace osgLego::test
