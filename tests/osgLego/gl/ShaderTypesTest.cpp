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
        std::ifstream file(shader);
        const std::string source(std::istreambuf_iterator<char>(file), {});
        EXPECT_FALSE(source.empty()) << shader;
        EXPECT_EQ(findBooleanMembers(source), std::vector<std::string>()) << shader << ": expected int";
    }
}

} // namespace

} // namespace osgLego::test
