#include <TemporaryFolder.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <vector>

#include <osg/Image>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

class Oiio : public TemporaryFolderTest
{
protected:
    /** An image of 5 x 3 different pixels. */
    static osg::ref_ptr<osg::Image> createImage(GLenum format, GLenum type)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(5, 3, 1, format, type);
        const unsigned int channels = osg::Image::computeNumComponents(format);
        for (unsigned int index = 0; index < 15 * channels; ++index)
        {
            unsigned char* pixel = image->data(index / channels % 5, index / channels / 5);
            const unsigned int channel = index % channels;
            if (type == GL_FLOAT)
            {
                const float value = 0.25f * static_cast<float>(index) + 3.5f;
                std::memcpy(pixel + std::size_t(4) * channel, &value, 4);
            }
            else if (type == GL_UNSIGNED_SHORT)
            {
                const auto value = static_cast<unsigned short>(1000 * index + 7);
                std::memcpy(pixel + std::size_t(2) * channel, &value, 2);
            }
            else
                pixel[channel] = static_cast<unsigned char>(4 * index + 1);
        }
        return image;
    }

    osg::ref_ptr<osg::Image> throughFile(const osg::Image& image, const std::string& name)
    {
        EXPECT_TRUE(osgDB::writeImageFile(image, pathOf(name))) << name;
        return osgDB::readRefImageFile(pathOf(name));
    }

    static std::string errorOf(const std::string& name)
    {
        osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readImage(name, nullptr);
        EXPECT_FALSE(result.validImage()) << name;
        return result.statusMessage();
    }

    static void expectSamePixels(const osg::Image& a, const osg::Image& b)
    {
        ASSERT_EQ(a.s(), b.s());
        ASSERT_EQ(a.t(), b.t());
        ASSERT_EQ(a.getPixelFormat(), b.getPixelFormat());
        ASSERT_EQ(a.getDataType(), b.getDataType());
        for (unsigned int row = 0; row < static_cast<unsigned int>(a.t()); ++row)
            EXPECT_EQ(std::memcmp(a.data(0, row), b.data(0, row), a.getRowSizeInBytes()), 0) << "row " << row;
    }
};

TEST_F(Oiio, FloatsAreKeptThroughExr)
{
    for (const GLenum format : std::initializer_list<GLenum>{GL_RGB, GL_RGBA})
    {
        const osg::ref_ptr<osg::Image> image = createImage(format, GL_FLOAT);
        const osg::ref_ptr<osg::Image> back = throughFile(*image, "image.exr");
        ASSERT_TRUE(back);
        expectSamePixels(*image, *back);
    }
}

TEST_F(Oiio, EveryTypeAndNumberOfChannelsGoesThroughTiff)
{
    for (const GLenum type : std::initializer_list<GLenum>{GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT})
        for (const GLenum format : std::initializer_list<GLenum>{GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA})
        {
            const osg::ref_ptr<osg::Image> image = createImage(format, type);
            const osg::ref_ptr<osg::Image> back = throughFile(*image, "image.tif.oiio");
            ASSERT_TRUE(back) << type << " " << format;
            expectSamePixels(*image, *back);
        }
}

TEST_F(Oiio, HdrKeepsThePrecisionOfItsFormat)
{
    const osg::ref_ptr<osg::Image> image = createImage(GL_RGB, GL_FLOAT);
    const osg::ref_ptr<osg::Image> back = throughFile(*image, "image.hdr.oiio");
    ASSERT_TRUE(back);
    ASSERT_EQ(back->getDataType(), GLenum(GL_FLOAT));
    for (unsigned int row = 0; row < 3; ++row)
        for (unsigned int column = 0; column < 5; ++column)
            EXPECT_NEAR(back->getColor(column, row).g(), image->getColor(column, row).g(), 0.1f);
}

TEST_F(Oiio, AlphaDoesNotChangeTheColours)
{
    const osg::ref_ptr<osg::Image> image = createImage(GL_RGBA, GL_UNSIGNED_BYTE);
    ASSERT_TRUE(osgDB::writeImageFile(*image, pathOf("image.png")));
    const osg::ref_ptr<osg::Image> back = osgDB::readRefImageFile(pathOf("image.png.oiio"));
    ASSERT_TRUE(back);
    expectSamePixels(*image, *back);
    const osg::ref_ptr<osg::Image> again = throughFile(*image, "again.png.oiio");
    ASSERT_TRUE(again);
    expectSamePixels(*image, *again);
}

TEST_F(Oiio, ImagesOfSeveralLayersAreRefused)
{
    // A DirectDraw surface of 4 x 4 x 4 pixels: the words of the header, and 256 bytes.
    std::vector<std::uint32_t> words(32 + 64, 0x80808080u);
    std::fill(words.begin(), words.begin() + 32, 0u);
    words[0] = 0x20534444; // "DDS "
    words[1] = 124;
    words[2] = 0x1 | 0x2 | 0x4 | 0x1000 | 0x800000; // caps, height, width, pixel format, depth
    words[3] = words[4] = words[6] = 4;
    words[19] = 32;
    words[20] = 0x41; // colours and alpha
    words[22] = 32;
    words[23] = 0x00ff0000;
    words[24] = 0x0000ff00;
    words[25] = 0x000000ff;
    words[26] = 0xff000000;
    words[27] = 0x1000 | 0x8; // texture, complex
    words[28] = 0x200000;     // volume
    std::ofstream(pathOf("volume.dds"), std::ios::binary)
        .write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
    osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readImage(pathOf("volume.dds.oiio"), nullptr);
    EXPECT_FALSE(result.validImage());
    EXPECT_NE(result.message().find("4 layers; expected one"), std::string::npos) << result.message();
}

TEST_F(Oiio, BgrIsWrittenAsRgb)
{
    const osg::ref_ptr<osg::Image> image = createImage(GL_BGR, GL_UNSIGNED_BYTE);
    const osg::ref_ptr<osg::Image> back = throughFile(*image, "image.png.oiio");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->data(2, 1)[0], image->data(2, 1)[2]);
    EXPECT_EQ(back->data(2, 1)[2], image->data(2, 1)[0]);
}

TEST_F(Oiio, AgreesWithOsgsPluginOnTheOrderOfRows)
{
    const osg::ref_ptr<osg::Image> image = createImage(GL_RGB, GL_UNSIGNED_BYTE);
    ASSERT_TRUE(osgDB::writeImageFile(*image, pathOf("image.png")));
    const osg::ref_ptr<osg::Image> back = osgDB::readRefImageFile(pathOf("image.png.oiio"));
    ASSERT_TRUE(back);
    expectSamePixels(*image, *back);
}

TEST_F(Oiio, ACorruptHeaderDoesNoHarm)
{
    std::ofstream(pathOf("huge.hdr"), std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40000 +X 40000\n";
    EXPECT_NE(errorOf(pathOf("huge.hdr.oiio")).find("40000 x 40000"), std::string::npos);
}

TEST_F(Oiio, ATruncatedFileIsAnError)
{
    ASSERT_TRUE(osgDB::writeImageFile(*createImage(GL_RGB, GL_FLOAT), pathOf("whole.exr")));
    const std::string whole = contentsOf(pathOf("whole.exr"));
    for (const std::size_t size : {std::size_t(0), std::size_t(10), whole.size() / 2, whole.size() - 10})
    {
        std::ofstream(pathOf("part.exr"), std::ios::binary) << whole.substr(0, size);
        EXPECT_FALSE(errorOf(pathOf("part.exr")).empty()) << size;
    }
}

TEST_F(Oiio, ReportsFailuresAndWritesNothing)
{
    EXPECT_NE(errorOf(pathOf("none.exr")).find("not found"), std::string::npos);
    EXPECT_FALSE(osgDB::writeImageFile(*createImage(GL_RGB, GL_FLOAT), pathOf("no/such/folder.exr")));
    osg::ref_ptr<osg::Image> volume = new osg::Image;
    volume->allocateImage(2, 2, 2, GL_RGB, GL_UNSIGNED_BYTE);
    EXPECT_FALSE(osgDB::writeImageFile(*volume, pathOf("volume.exr")));
    EXPECT_EQ(countFiles(), 0u);
}

} // namespace

} // namespace osgLego::test
