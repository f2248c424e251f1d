#include <osgLego/passes/PaletteTextures.h>

#include <osgLego/gl/ProgramUniforms.h>

#include <algorithm>
#include <array>

#include <osg/Image>

namespace osgLego
{

namespace
{

void setUnfiltered(osg::Texture& texture)
{
    for (const auto parameter : {osg::Texture::MIN_FILTER, osg::Texture::MAG_FILTER})
        texture.setFilter(parameter, osg::Texture::NEAREST);
    for (const auto parameter : {osg::Texture::WRAP_S, osg::Texture::WRAP_T, osg::Texture::WRAP_R})
        texture.setWrap(parameter, osg::Texture::CLAMP_TO_EDGE);
    texture.setResizeNonPowerOfTwoHint(false);
}

osg::ref_ptr<osg::Image> createTableImage(GLenum format, GLint internalFormat)
{
    constexpr int SIDE = Palette::TABLE_SIDE;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(SIDE, SIDE, SIDE, format, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(internalFormat);
    return image;
}

osg::ref_ptr<osg::Texture3D> createTable(const PaletteLookup& lookup)
{
    osg::ref_ptr<osg::Image> image;
    if (lookup.getDithers())
    {
        image = createTableImage(GL_RGB, GL_RGB8);
        unsigned char* texel = image->data();
        for (const auto& [first, second, share] : lookup.getPalette()->getMixtures())
            texel = std::ranges::copy(std::array{first, second, share}, texel).out;
    }
    else
    {
        image = createTableImage(GL_RED, GL_R8);
        std::ranges::copy(lookup.getPalette()->getTable(), image->data());
    }
    osg::ref_ptr<osg::Texture3D> texture = new osg::Texture3D(image);
    setUnfiltered(*texture);
    return texture;
}

osg::ref_ptr<osg::Texture2D> createColors(const Palette& palette)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(static_cast<int>(palette.getColors().size()), 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_RGBA8);
    unsigned char* texel = image->data();
    for (const PaletteColor& color : palette.getColors())
    {
        texel = std::ranges::copy(color.color, texel).out;
        *texel++ = 255;
    }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    setUnfiltered(*texture);
    return texture;
}

} // namespace

PaletteTextures::PaletteTextures(const PaletteLookup& lookup) :
    _lookup(lookup), _table(createTable(lookup)), _colors(createColors(*lookup.getPalette()))
{
}

void PaletteTextures::bind(osg::State& state, unsigned int tableUnit, unsigned int colorsUnit) const
{
    state.applyTextureAttribute(tableUnit, _table);
    state.haveAppliedTextureAttribute(tableUnit, _table);
    state.applyTextureAttribute(colorsUnit, _colors);
    state.haveAppliedTextureAttribute(colorsUnit, _colors);
    const ProgramUniforms uniforms(state);
    uniforms.set("paletteTable", static_cast<int>(tableUnit));
    uniforms.set("paletteColors", static_cast<int>(colorsUnit));
}

void PaletteTextures::releaseGLObjects(osg::State* state) const
{
    _table->releaseGLObjects(state);
    _colors->releaseGLObjects(state);
}

} // namespace osgLego
