#include "GltfDocument.h"

#include <osgLego/LegoNode.h>

#include <Notices.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Material>
#include <osg/Texture2D>
#include <osg/TriangleIndexFunctor>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

const std::string TEST_MODELS = "/usr/share/assimp/models"; // of Debian's package assimp-testmodels

struct Triangles
{
    std::vector<osg::Vec3> corners;
    void operator()(unsigned int a, unsigned int b, unsigned int c)
    {
        for (const unsigned int index : {a, b, c})
            corners.push_back((*vertices)[index] * toWorld);
    }
    const osg::Vec3Array* vertices = nullptr;
    osg::Matrixd toWorld;
};

/** Collects the geometries of a scene, and the corners of its triangles in world coordinates. */
class Content : public osg::NodeVisitor
{
public:
    explicit Content(osg::Node& scene) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { scene.accept(*this); }

    using osg::NodeVisitor::apply;
    void apply(osg::Geometry& geometry) override
    {
        geometries.push_back(&geometry);
        osg::TriangleIndexFunctor<Triangles> triangles;
        triangles.vertices = dynamic_cast<const osg::Vec3Array*>(geometry.getVertexArray());
        triangles.toWorld = osg::computeLocalToWorld(getNodePath());
        geometry.accept(triangles);
        corners.insert(corners.end(), triangles.corners.begin(), triangles.corners.end());
    }

    std::vector<osg::ref_ptr<osg::Geometry>> geometries;
    std::vector<osg::Vec3> corners;
};

class AssimpReader : public TemporaryFolderTest
{
protected:
    static GltfDocument createTriangle()
    {
        GltfDocument document;
        document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        document.addPrimitive(R"("POSITION":0)");
        return document;
    }

    /** A square with a texture whose upper row is red and green and whose lower row is blue and white. */
    static GltfDocument createTexturedSquare()
    {
        GltfDocument document;
        document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
        document.add(std::vector<osg::Vec2>{{0.25f, 0.75f}, {0.75f, 0.75f}, {0.75f, 0.25f}, {0.25f, 0.25f}});
        document.addIndices({0, 1, 2, 0, 2, 3});
        document.addPrimitive(R"("POSITION":0,"TEXCOORD_0":1)", R"("indices":2)");
        document.material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
        document.texture = R"({"source":0,"sampler":0})";
        return document;
    }

    std::string createPicture() const
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
        image->setColor(osg::Vec4(0, 0, 1, 1), 0, 0);
        image->setColor(osg::Vec4(1, 1, 1, 1), 1, 0);
        image->setColor(osg::Vec4(1, 0, 0, 1), 0, 1);
        image->setColor(osg::Vec4(0, 1, 0, 1), 1, 1);
        EXPECT_TRUE(osgDB::writeImageFile(*image, pathOf("picture of the test.png")));
        return contentsOf(pathOf("picture of the test.png"));
    }

    void write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(pathOf(name), std::ios::binary) << bytes;
    }

    osg::ref_ptr<osg::Node> read(const std::string& name, const std::string& options = {}) const
    {
        const osg::ref_ptr<osgDB::Options> used = new osgDB::Options(options);
        osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(pathOf(name), used);
        EXPECT_TRUE(result.validNode()) << name << ": " << result.statusMessage();
        return result.getNode();
    }

    Content contentOf(const GltfDocument& document, const std::string& options = {}) const
    {
        write("model.glb", document.toBinary());
        const osg::ref_ptr<osg::Node> node = read("model.glb", options);
        return Content(node ? *node : *osg::ref_ptr<osg::Node>(new osg::Node));
    }

    std::string errorOf(const std::string& name) const
    {
        osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(pathOf(name), nullptr);
        EXPECT_FALSE(result.validNode()) << name;
        return result.statusMessage();
    }

    std::string errorOf(const GltfDocument& document) const
    {
        write("model.glb", document.toBinary());
        return errorOf("model.glb");
    }

    static osg::Vec4 colorOf(const osg::Geometry& geometry, unsigned int vertex = 0)
    {
        return dynamic_cast<const osg::Vec4Array&>(*geometry.getColorArray())[vertex];
    }

    /** Expect that each corner of a textured square has the colour of its quarter of the picture. */
    static void expectPicture(const osg::Geometry& geometry)
    {
        const auto* texture = dynamic_cast<const osg::Texture2D*>(
            geometry.getStateSet()->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
        ASSERT_TRUE(texture && texture->getImage());
        const auto& vertices = dynamic_cast<const osg::Vec3Array&>(*geometry.getVertexArray());
        const auto& coordinates = dynamic_cast<const osg::Vec2Array&>(*geometry.getTexCoordArray(0));
        ASSERT_EQ(vertices.size(), coordinates.size());
        for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
        {
            const bool isRight = vertices[vertex].x() > 0.5f;
            const bool isUpper = vertices[vertex].y() > 0.5f;
            const osg::Vec4 expected = isUpper ? (isRight ? osg::Vec4(0, 1, 0, 1) : osg::Vec4(1, 0, 0, 1))
                                               : (isRight ? osg::Vec4(1, 1, 1, 1) : osg::Vec4(0, 0, 1, 1));
            const auto column = static_cast<unsigned int>(2.0f * coordinates[vertex].x());
            const auto row = static_cast<unsigned int>(2.0f * coordinates[vertex].y()); // from below
            EXPECT_EQ(texture->getImage()->getColor(column, row), expected) << vertex;
        }
    }
};

TEST_F(AssimpReader, TurnsTrianglesUprightBelowTheirTransforms)
{
    GltfDocument document = createTriangle();
    document.nodes = R"([{"translation":[10,20,30],"children":[1]},{"scale":[2,3,4],"mesh":0}])";
    const Content content = contentOf(document);
    // In glTF, the corners are at (10, 20, 30), (12, 20, 30) and (10, 23, 30).
    EXPECT_EQ(content.corners, (std::vector<osg::Vec3>{{10, -30, 20}, {12, -30, 20}, {10, -30, 23}}));
}

TEST_F(AssimpReader, KeepsTheLengthOfNormalsBelowScales)
{
    for (const std::string scale : {"1,1,1", "100,100,100", "1,1,0.5"})
    {
        GltfDocument document = createTriangle();
        document.nodes = R"([{"translation":[10,20,30],"children":[1]},{"scale":[)" + scale + R"(],"mesh":0}])";
        write("model.glb", document.toBinary());
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf("model.glb"));
        ASSERT_TRUE(node);
        EXPECT_FALSE(node->getStateSet()) << scale;
        const osg::StateSet* states = node->asGroup()->getChild(0)->getStateSet();
        const bool isNormalized = states && states->getMode(GL_NORMALIZE) == osg::StateAttribute::ON;
        EXPECT_EQ(isNormalized, scale != "1,1,1") << scale;
    }
}

TEST_F(AssimpReader, PlacesInstances)
{
    GltfDocument document = createTriangle();
    document.add(std::vector<osg::Vec3>{{10, 0, 0}, {0, 20, 0}});
    document.add(std::vector<osg::Vec4>{{0, 0, 0, 1}, {0, 0, 1, 0}}); // the second by half a turn about z
    document.add(std::vector<osg::Vec3>{{1, 1, 1}, {2, 3, 1}});
    document.nodes = R"([{"children":[1,2]},{"translation":[0,0,5]},{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":
        {"attributes":{"TRANSLATION":1,"ROTATION":2,"SCALE":3}}}}])";
    EXPECT_EQ(contentOf(document, "noRotation").corners,
              (std::vector<osg::Vec3>{{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {0, 20, 0}, {-2, 20, 0}, {0, 17, 0}}));
}

TEST_F(AssimpReader, RejectsInstancesBeyondTheBuffer)
{
    GltfDocument document = createTriangle();
    document.nodes = R"([{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"ROTATION":0}}}}])";
    EXPECT_NE(errorOf(document).find("its instances of EXT_mesh_gpu_instancing can't be read"), std::string::npos);
}

TEST_F(AssimpReader, KeepsTheAxesWithNoRotation)
{
    EXPECT_EQ(contentOf(createTriangle(), "noRotation").corners,
              (std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(AssimpReader, ConvertsLinearBaseColoursToDisplayValues)
{
    GltfDocument document = createTriangle();
    document.material = R"({"pbrMetallicRoughness":{"baseColorFactor":[0.2158605,0.0,1.0,0.5]}})"; // 128 of 255 in sRGB
    const Content content = contentOf(document);
    ASSERT_EQ(content.geometries.size(), 1u);
    const osg::Vec4 expected(128.0f / 255.0f, 0.0f, 1.0f, 0.5f);
    EXPECT_LT((colorOf(*content.geometries[0]) - expected).length(), 1e-5f);
    const auto* material = dynamic_cast<const osg::Material*>(
        content.geometries[0]->getStateSet()->getAttribute(osg::StateAttribute::MATERIAL));
    ASSERT_TRUE(material);
    EXPECT_LT((material->getDiffuse(osg::Material::FRONT) - expected).length(), 1e-5f);
}

TEST_F(AssimpReader, MultipliesVertexColoursByTheBaseColour)
{
    GltfDocument document;
    document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    document.add(std::vector<osg::Vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}});
    document.addPrimitive(R"("POSITION":0,"COLOR_0":1)");
    document.material = R"({"pbrMetallicRoughness":{"baseColorFactor":[1.0,0.0,0.2158605,1.0]}})";
    const Content content = contentOf(document);
    ASSERT_EQ(content.geometries.size(), 1u);
    EXPECT_EQ(colorOf(*content.geometries[0], 0), osg::Vec4(1, 0, 0, 1));
    EXPECT_EQ(colorOf(*content.geometries[0], 1), osg::Vec4(0, 0, 0, 1));
    EXPECT_LT((colorOf(*content.geometries[0], 2) - osg::Vec4(0, 0, 128.0f / 255.0f, 1)).length(), 1e-5f);
}

TEST_F(AssimpReader, GivesTrianglesWithoutNormalsThoseOfTheirPlanes)
{
    GltfDocument document;
    document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    document.addIndices({0, 1, 2, 0, 3, 1}); // in the planes z = 0 and y = 0
    document.addPrimitive(R"("POSITION":0)", R"("indices":1)");
    const Content content = contentOf(document);
    ASSERT_EQ(content.geometries.size(), 1u);
    const auto& normals = dynamic_cast<const osg::Vec3Array&>(*content.geometries[0]->getNormalArray());
    std::vector<unsigned int> indices;
    for (unsigned int index = 0; index < 6; ++index)
        indices.push_back(content.geometries[0]->getPrimitiveSet(0)->index(index));
    for (unsigned int corner = 0; corner < 6; ++corner)
        EXPECT_LT((normals[indices[corner]] - (corner < 3 ? osg::Vec3(0, 0, 1) : osg::Vec3(0, 1, 0))).length(), 1e-6f);
}

TEST_F(AssimpReader, ReadsEmbeddedPictures)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    const Content content = contentOf(document);
    ASSERT_EQ(content.geometries.size(), 1u);
    expectPicture(*content.geometries[0]);
    const auto* texture = dynamic_cast<const osg::Texture2D*>(
        content.geometries[0]->getStateSet()->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    EXPECT_EQ(texture->getWrap(osg::Texture::WRAP_S), osg::Texture::CLAMP_TO_EDGE);
    EXPECT_EQ(texture->getWrap(osg::Texture::WRAP_T), osg::Texture::REPEAT);
}

TEST_F(AssimpReader, ReadsEmbeddedPicturesWhileAReaderWithoutStreamsIsLoaded)
{
    ASSERT_TRUE(osgDB::Registry::instance()->getReaderWriterForExtension("oiio"));
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    const Content content = contentOf(document);
    ASSERT_EQ(content.geometries.size(), 1u);
    expectPicture(*content.geometries[0]);
}

TEST_F(AssimpReader, ReadsPicturesAndBuffersBesideTheFile)
{
    GltfDocument document = createTexturedSquare();
    document.addPictureFile("a%20picture.png");
    write("a picture.png", createPicture());
    write("square.bin", document.getBuffer());
    write("square.gltf", document.toText("square.bin"));
    const Content content(*read("square.gltf"));
    ASSERT_EQ(content.geometries.size(), 1u);
    expectPicture(*content.geometries[0]);
}

TEST_F(AssimpReader, FindsOtherFilesInOsgsPath)
{
    GltfDocument document = createTexturedSquare();
    document.addPictureFile("picture.png");
    std::filesystem::create_directory(_folder / "elsewhere");
    write("elsewhere/picture.png", createPicture());
    write("elsewhere/square.bin", document.getBuffer());
    write("square.gltf", document.toText("square.bin"));
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->getDatabasePathList().push_back(pathOf("elsewhere"));
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf("square.gltf"), options);
    ASSERT_TRUE(node);
    const Content content(*node);
    ASSERT_EQ(content.geometries.size(), 1u);
    expectPicture(*content.geometries[0]);
}

/** Finds a picture of one name that is not in any folder, as those of archives do. */
class PictureFinder : public osgDB::FindFileCallback
{
public:
    explicit PictureFinder(std::string place) : _place(std::move(place)) {}

    std::string findDataFile(const std::string& fileName, const osgDB::Options* options,
                             osgDB::CaseSensitivity sensitivity) override
    {
        return fileName == "wood grain.png" ? _place : FindFileCallback::findDataFile(fileName, options, sensitivity);
    }

private:
    std::string _place;
};

TEST_F(AssimpReader, AsksTheApplicationForPictures)
{
    write("stored.png", createPicture());
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    const osg::ref_ptr<PictureFinder> finder = new PictureFinder(pathOf("stored.png"));
    options->setFindFileCallback(finder);
    for (const std::string name : {"wood grain.png", "wood%20grain.png", "C:/work/wood%20grain.png"})
    {
        GltfDocument document = createTexturedSquare();
        document.addPictureFile(name);
        write("model.glb", document.toBinary());
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf("model.glb"), options);
        ASSERT_TRUE(node);
        const Content content(*node);
        ASSERT_EQ(content.geometries.size(), 1u);
        expectPicture(*content.geometries[0]);
    }
}

TEST_F(AssimpReader, WarnsOnceOfAMissingPicture)
{
    GltfDocument document = createTexturedSquare();
    document.addPictureFile("missing.png");
    document.material += "," + document.material;
    document.addPrimitive(R"("POSITION":0,"TEXCOORD_0":1)", R"("indices":2)", 1);
    const std::string notices = noticesOf([&] { EXPECT_EQ(contentOf(document).geometries.size(), 2u); });
    EXPECT_EQ(std::count(notices.begin(), notices.end(), '\n'), 1) << notices;
    EXPECT_NE(notices.find("model.glb': can't read its texture 'missing.png'"), std::string::npos) << notices;
}

TEST_F(AssimpReader, WarnsOfADamagedPicture)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture().substr(0, 30));
    const std::string notices = noticesOf([&] { EXPECT_EQ(contentOf(document).geometries.size(), 1u); });
    EXPECT_NE(notices.find("it is damaged; expected a complete .png picture"), std::string::npos) << notices;
}

TEST_F(AssimpReader, KeepsAlphaMasksAndBlending)
{
    GltfDocument document = createTriangle();
    const auto stateOf = [&](const std::string& material)
    {
        document.material = material;
        return osg::ref_ptr<osg::StateSet>(contentOf(document).geometries.at(0)->getStateSet());
    };
    const auto opaque = stateOf(R"({"pbrMetallicRoughness":{"baseColorFactor":[1.0,1.0,1.0,0.5]}})");
    EXPECT_FALSE(opaque->getAttribute(osg::StateAttribute::ALPHAFUNC));
    EXPECT_FALSE(opaque->getAttribute(osg::StateAttribute::BLENDFUNC));
    const auto mask = stateOf(R"({"alphaMode":"MASK","alphaCutoff":0.25})");
    const auto* function = dynamic_cast<const osg::AlphaFunc*>(mask->getAttribute(osg::StateAttribute::ALPHAFUNC));
    ASSERT_TRUE(function);
    EXPECT_EQ(function->getFunction(), osg::AlphaFunc::GEQUAL);
    EXPECT_EQ(function->getReferenceValue(), 0.25f);
    const auto blend = stateOf(R"({"alphaMode":"BLEND"})");
    EXPECT_TRUE(blend->getAttribute(osg::StateAttribute::BLENDFUNC));
    EXPECT_EQ(blend->getRenderingHint(), int(osg::StateSet::TRANSPARENT_BIN));
}

TEST_F(AssimpReader, ReadsStreams)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    std::istringstream stream(document.toBinary());
    osgDB::ReaderWriter::ReadResult result =
        osgDB::Registry::instance()->getReaderWriterForExtension("glb")->readNode(stream, nullptr);
    ASSERT_TRUE(result.validNode()) << result.statusMessage();
    const Content content(*result.getNode());
    ASSERT_EQ(content.geometries.size(), 1u);
    expectPicture(*content.geometries[0]);
}

TEST_F(AssimpReader, ReadsOffFilesAsTheyAre)
{
    write("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 2 0\n0 2 3\n4 0 1 2 3\n");
    const Content content(*read("square.off"));
    ASSERT_EQ(content.corners.size(), 6u);
    for (const osg::Vec3& corner : std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}})
        EXPECT_NE(std::find(content.corners.begin(), content.corners.end(), corner), content.corners.end());
}

TEST_F(AssimpReader, GivesBricksInTheColoursOfTheFile)
{
    GltfDocument document = createTriangle();
    document.material = R"({"pbrMetallicRoughness":{"baseColorFactor":[0.2158605,0.0,1.0,1.0]}})";
    write("model.glb", document.toBinary());
    const osg::ref_ptr<LegoNode> lego = dynamic_cast<LegoNode*>(read("model.glb.(8,occlusion=off).legolize").get());
    ASSERT_TRUE(lego);
    const osg::ref_ptr<const BrickModel> bricks = lego->getBricks();
    ASSERT_TRUE(bricks);
    EXPECT_EQ(bricks->getGrid().dimensions, glm::ivec3(8, 1, 8)); // upright: x and z
    EXPECT_FALSE(bricks->getBricks().empty());
    for (const Brick& brick : bricks->getBricks())
        EXPECT_EQ(brick.color, (std::array<std::uint8_t, 3>{128, 0, 255}));
}

TEST_F(AssimpReader, NamesTheFileThatItCantRead)
{
    write("empty.glb", {});
    write("text.fbx", "no model");
    EXPECT_NE(errorOf("empty.glb").find("osgLego: can't read '" + pathOf("empty.glb") + "'"), std::string::npos);
    const std::string error = errorOf("text.fbx");
    EXPECT_NE(error.find("osgLego: can't read '" + pathOf("text.fbx") + "'"), std::string::npos) << error;
    EXPECT_NE(error.find("expected a valid, complete file"), std::string::npos) << error;
}

TEST_F(AssimpReader, RejectsFilesThatAssimpCantSurvive)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    std::string text = document.toText("square.bin");
    text.replace(text.find("image/png"), 9, "image-png");
    write("square.bin", document.getBuffer());
    write("square.gltf", text);
    EXPECT_NE(errorOf("square.gltf").find("'image-png' is not a MIME type"), std::string::npos);
    write("huge.off", "OFF\n# a comment\n1 2000000000 0\n0 0 0\n");
    const std::string error = errorOf("huge.off");
    EXPECT_NE(error.find("2000000000 faces; expected at most as many as its 37 characters"), std::string::npos)
        << error;
}

TEST_F(AssimpReader, RejectsFilesThatRequireWhatAssimpIgnores)
{
    std::string text = createTriangle().toText("triangle.bin");
    text.insert(1, R"("extensionsRequired":["KHR_texture_transform","EXT_mesh_gpu_instancing"],)");
    write("triangle.bin", createTriangle().getBuffer());
    write("triangle.gltf", text);
    EXPECT_NE(errorOf("triangle.gltf").find("it requires the extension EXT_mesh_gpu_instancing; expected it in a .glb"),
              std::string::npos);
}

TEST_F(AssimpReader, RejectsEveryTruncatedFile)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    const std::string binary = document.toBinary();
    for (std::size_t size = 0; size < binary.size(); size += 13)
    {
        write("model.glb", binary.substr(0, size));
        EXPECT_NE(errorOf("model.glb").find("model.glb"), std::string::npos) << size;
    }
}

TEST_F(AssimpReader, SurvivesDamagedFiles)
{
    GltfDocument document = createTexturedSquare();
    document.addPicture(createPicture());
    const std::string binary = document.toBinary();
    std::mt19937 random(1);
    unsigned int numRead = 0;
    noticesOf(
        [&]
        {
            for (int attempt = 0; attempt < 300; ++attempt)
            {
                std::string damaged = binary;
                damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
                write("model.glb", damaged);
                osgDB::ReaderWriter::ReadResult result =
                    osgDB::Registry::instance()->readNode(pathOf("model.glb"), nullptr);
                if (!result.validNode()) continue;
                ++numRead;
                for (const osg::Vec3& corner : Content(*result.getNode()).corners)
                    EXPECT_TRUE(corner.valid());
            }
        });
    EXPECT_GT(numRead, 0u);
    EXPECT_LT(numRead, 300u);
}

TEST_F(AssimpReader, RejectsVerticesThatAreNotFinite)
{
    for (const float value : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
    {
        GltfDocument document;
        document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, value, 0}});
        document.addPrimitive(R"("POSITION":0)");
        EXPECT_NE(errorOf(document).find("expected finite coordinates"), std::string::npos);
    }
}

TEST_F(AssimpReader, RejectsTransformsThatAreNotFinite)
{
    GltfDocument document = createTriangle();
    document.nodes = R"([{"mesh":0,"matrix":[1e39,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])";
    EXPECT_NE(errorOf(document).find("is infinite or not a number; expected finite values"), std::string::npos);
}

TEST_F(AssimpReader, LeavesOutTrianglesBeyondTheVertices)
{
    GltfDocument document;
    document.add(std::vector<osg::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    document.addIndices({0, 1, 2, 0, 1, 3});
    document.addPrimitive(R"("POSITION":0)", R"("indices":1)");
    EXPECT_EQ(contentOf(document).corners.size(), 3u);
}

TEST_F(AssimpReader, IsFoundByEveryExtensionThatItReads)
{
    const osgDB::ReaderWriter* reader = osgDB::Registry::instance()->getReaderWriterForExtension("glb");
    ASSERT_TRUE(reader);
    EXPECT_GE(reader->supportedExtensions().size(), 4u);
    for (const auto& [extension, description] : reader->supportedExtensions())
        EXPECT_FALSE(
            osgDB::findLibraryFile(osgDB::Registry::instance()->createLibraryNameForExtension(extension)).empty())
            << extension;
}

TEST_F(AssimpReader, ReadsTheModelsOfAssimp)
{
    if (!std::filesystem::is_directory(TEST_MODELS))
        GTEST_SKIP() << "skipped: there is no " << TEST_MODELS << " (Debian: assimp-testmodels)";
    const auto trianglesOf = [](const std::string& name)
    {
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(TEST_MODELS + name);
        return node ? Content(*node).corners.size() / 3 : 0;
    };
    EXPECT_EQ(trianglesOf("/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"), 12u);
    EXPECT_EQ(trianglesOf("/glTF2/BoxTextured-glTF/BoxTextured.gltf"), 12u);
    EXPECT_EQ(trianglesOf("/FBX/box.fbx"), 12u);
    EXPECT_EQ(trianglesOf("/OFF/Cube.off"), 12u);
}

TEST_F(AssimpReader, ReadsOrRejectsEverySmallModelOfAssimp)
{
    if (!std::filesystem::is_directory(TEST_MODELS))
        GTEST_SKIP() << "skipped: there is no " << TEST_MODELS << " (Debian: assimp-testmodels)";
    const osgDB::ReaderWriter* reader = osgDB::Registry::instance()->getReaderWriterForExtension("glb");
    unsigned int numRead = 0;
    noticesOf(
        [&]
        {
            for (const auto& entry : std::filesystem::recursive_directory_iterator(TEST_MODELS))
            {
                const std::string name = entry.path().string();
                if (!reader->acceptsExtension(osgDB::getLowerCaseFileExtension(name)) || entry.file_size() > 300000)
                    continue;
                osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(name, nullptr);
                numRead += result.validNode() ? 1 : 0;
                EXPECT_TRUE(result.validNode() ||
                            result.statusMessage().find("osgLego: can't read") != std::string::npos)
                    << name << ": " << result.statusMessage();
            }
        });
    EXPECT_GT(numRead, 50u);
}

} // namespace

} // namespace osgLego::test
