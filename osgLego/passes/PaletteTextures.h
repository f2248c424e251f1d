#pragma once

#include <osgLego/Palette.h>

#include <osg/Referenced>
#include <osg/State>
#include <osg/Texture2D>
#include <osg/Texture3D>
#include <osg/ref_ptr>

namespace osgLego
{

/** A palette on the GPU, for shaders/extraction/palette_color.glsl: its table of indices as a 3D texture, and its
 * colours as a row of texels.
 *
 * Can be created without a context, and serves all contexts.
 */
class PaletteTextures : public osg::Referenced
{
public:
    explicit PaletteTextures(const Palette& palette);

    const Palette& getPalette() const { return *_palette; }

    /** Bind the textures to units, and set the uniforms, for the program that was applied last. Needs the context
     * current. */
    void bind(osg::State& state, unsigned int tableUnit, unsigned int colorsUnit) const;

    void releaseGLObjects(osg::State* state) const;

private:
    ~PaletteTextures() override = default;

    osg::ref_ptr<const Palette> _palette;
    osg::ref_ptr<osg::Texture3D> _table;
    osg::ref_ptr<osg::Texture2D> _colors;
};

} // namespace osgLego
