#include <TemporaryFolder.h>

#include <cstdint>
#include <functional>

#include <osgDB/Registry>

namespace osgLego::test
{

namespace
{

std::string repeat(const std::string& text, std::size_t count)
{
    std::string result;
    for (std::size_t time = 0; time < count; ++time)
        result += text;
    return result;
}

/** A number in binary files. */
std::string word(std::size_t number)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(number >> shift & 0xff);
    return bytes;
}

std::string toGlb(std::string json)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

std::string toGltfOfNodes(const std::string& nodes)
{
    return R"({"asset":{"version":"2.0"},"extras":{"nodes":[]},"scene":0,"scenes":[{"nodes":[0]}], "nodes" : [)" +
           nodes + "]}";
}

std::string createGltfChain(std::size_t levels)
{
    std::string nodes;
    for (std::size_t level = 1; level < levels; ++level)
        nodes += R"({"children":[)" + std::to_string(level) + "]},";
    return toGltfOfNodes(nodes + "{}");
}

/** Records in records, each of an offset of its end, the number and length of its properties, and a name. */
std::string createBinaryFbx(std::size_t levels)
{
    const std::string begin("Kaydara FBX Binary  \0\x1a\0", 23);
    constexpr std::size_t HEADER = 14;
    constexpr std::size_t END_OF_LIST = 13;
    std::string bytes = begin + word(7400);
    const std::size_t innermost = bytes.size() + HEADER * levels;
    for (std::size_t level = 1; level <= levels; ++level)
        bytes += word(innermost + END_OF_LIST * (levels - level)) + word(0) + word(0) + "\1A";
    return bytes + std::string(END_OF_LIST * levels, '\0');
}

std::string createB3d(std::size_t levels)
{
    constexpr std::size_t NODE = 42; // name and transform
    std::string bytes = "BB3D" + word(4 + levels * (8 + NODE)) + word(1);
    for (std::size_t level = levels; level > 0; --level)
        bytes += "NODE" + word(level * (8 + NODE) - 8) + std::string("N\0", 2) + std::string(NODE - 2, '\0');
    return bytes;
}

/** A file format, and a file without a mesh, nested in a number of levels. */
struct NestedFormat
{
    const char* extension;
    const char* elements; // in the message
    std::function<std::string(std::size_t levels)> create;
};

const NestedFormat FORMATS[] = {
    {"gltf", "values", [](std::size_t levels) { return repeat("[", levels) + repeat("]", levels); }},
    {"glb", "values", [](std::size_t levels) { return toGlb(repeat("{\"a\":", levels) + "0" + repeat("}", levels)); }},
    {"gltf", "nodes", createGltfChain},
    {"glb", "nodes", [](std::size_t levels) { return toGlb(createGltfChain(levels)); }},
    {"fbx", "elements",
     [](std::size_t levels)
     { return "; a comment \" {\nA: \"{{\"\n" + repeat("A: {\n", levels) + repeat("}\n", levels); }},
    {"fbx", "elements", createBinaryFbx},
    {"b3d", "elements", createB3d},
    {"x3d", "elements",
     [](std::size_t levels)
     {
         return "<?xml version=\"1.0\"?><!-- <a> --><X3D><b c=\">\"/><![CDATA[<d>]]>" + repeat("<Group>", levels - 1) +
                repeat("</Group>", levels - 1) + "</X3D>";
     }},
    {"xgl", "elements", [](std::size_t levels) { return repeat("<OBJECT>", levels) + repeat("</OBJECT>", levels); }},
};

class Nesting : public TemporaryFolderTest
{
protected:
    std::string errorOf(const char* extension, const std::string& bytes) const
    {
        const std::string path = pathOf(std::string("model.") + extension);
        std::ofstream(path, std::ios::binary) << bytes;
        osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(path, nullptr);
        EXPECT_FALSE(result.validNode()) << extension;
        return result.statusMessage();
    }
};

TEST_F(Nesting, OfTooManyLevelsIsAnError)
{
    for (const NestedFormat& format : FORMATS)
    {
        const std::string expected =
            std::string("its ") + format.elements + " are nested too deeply; expected at most 500 levels";
        for (const std::size_t levels : {501u, 200000u})
        {
            const std::string error = errorOf(format.extension, format.create(levels));
            EXPECT_NE(error.find(expected), std::string::npos) << format.extension << ": " << error;
        }
        const std::string error = errorOf(format.extension, format.create(500));
        EXPECT_EQ(error.find("nested"), std::string::npos) << format.extension << ": " << error;
    }
}

TEST_F(Nesting, OfMoreElementsBesideEachOtherIsNoError)
{
    EXPECT_EQ(errorOf("gltf", repeat("[]", 1000)).find("nested"), std::string::npos);
    EXPECT_EQ(errorOf("xgl", repeat("<OBJECT></OBJECT>", 1000)).find("nested"), std::string::npos);
    EXPECT_EQ(errorOf("fbx", repeat("A: {\n}\n", 1000)).find("nested"), std::string::npos);
}

TEST_F(Nesting, OfNodesWithAnEscapedNameIsAnErrorToo)
{
    std::string escaped = createGltfChain(501);
    const std::string key = "\"nodes\" : [";
    const std::size_t place = escaped.find(key);
    ASSERT_NE(place, std::string::npos);
    escaped.replace(place, key.size(), R"("\u006eodes" : [)");
    EXPECT_NE(errorOf("gltf", escaped).find("nested too deeply"), std::string::npos);
}

TEST_F(Nesting, OfNodesInTwoListsIsAnError)
{
    // Of two values with one name, Assimp uses the first, and the reader of instances the last.
    const std::string harmless = toGltfOfNodes("{}");
    const std::string twice =
        harmless.substr(0, harmless.rfind('}')) + R"(,"nodes":[{"children":[1]},{"children":[0]}]})";
    EXPECT_NE(errorOf("gltf", twice).find("several lists of nodes; expected one"), std::string::npos);
}

TEST_F(Nesting, OfDamagedKeysTakesNoLongerThanTheirText)
{
    // Quadratic time would be hours.
    for (const std::string key : {":[]", "\"a\":[]", "\"\\\"nodes\":[],\"\\\"nodes\":[]"})
    {
        const std::string error = errorOf("gltf", "{" + repeat(key, 1000000) + "}");
        EXPECT_EQ(error.find("several lists"), std::string::npos) << error;
    }
}

TEST_F(Nesting, OfANodeInTwoNodesIsAnError)
{
    // Each node twice in the one before: 2^30 nodes in all.
    std::string nodes;
    for (int level = 1; level <= 30; ++level)
        nodes += R"({"children":[)" + std::to_string(level) + "," + std::to_string(level) + "]},";
    EXPECT_NE(errorOf("gltf", toGltfOfNodes(nodes + "{}")).find("expected one parent for each node"),
              std::string::npos);
}

} // namespace

} // namespace osgLego::test
