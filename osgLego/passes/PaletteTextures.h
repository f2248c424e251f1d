#pragma once

#include <osgLego/palette/PaletteLookup.h>

#include <osg/Referenced>
#include <osg/State>
#include <osg/Texture2D>
#include <osg/Texture3D>
#include <osg/ref_ptr>

namespace osgLego
{

/** A palette on the GPU, for shaders/extraction/palette_color.glsl: its table of indices, or of mixtures, as a
 * 3D texture, and its colours as a row of texels.
 *
 * Can be created without a context, and serves all contexts.
 */
class PaletteTextures : public osg::Referenced
{
public:
    /** @param lookup has a palette. */
    explicit PaletteTextures(const PaletteLookup& lookup);

    const PaletteLookup& getLookup() const { return _lookup; }

    /** Bind the textures to units, and set the uniforms, for the program that was applied last. Needs the context
     * current. */
    void bind(osg::State& state, unsigned int tableUnit, unsigned int colorsUnit) const;

    void releaseGLObjects(osg::State* state) const;

private:
    ~PaletteTextures() override = default;

    PaletteLookup _lookup;
    osg::ref_ptr<osg::Texture3D> _table;
    osg::ref_ptr<osg::Texture2D> _colors;
};

} // namespace osgLego
