#include <osgLego/passes/PassWorkspace.h>

#include <osgLego/passes/SurfaceBinding.h>

namespace osgLego
{

void PassWorkspace::setSource(const LegoSource& source, const BrickSet& bricks)
{
    const std::lock_guard lock(_mutex);
    if (_wanted.source == &source) return;
    _wanted = {&source, &bricks};
    _textures.clear();
}

void PassWorkspace::clearSource()
{
    const std::lock_guard lock(_mutex);
    _wanted = {};
    _textures.clear();
    _paletteTextures = nullptr;
}

WantedBricks PassWorkspace::getWanted() const
{
    const std::lock_guard lock(_mutex);
    return _wanted;
}

osg::ref_ptr<PassContext> PassWorkspace::getContext(unsigned int contextID) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<PassContext>& context = _contexts[contextID];
    if (!context) context = new PassContext;
    return context;
}

osg::ref_ptr<osg::Texture2D> PassWorkspace::getTexture(const SurfaceTexture& surface) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::Texture2D>& texture = _textures[&surface];
    if (!texture) texture = createSurfaceTexture(surface);
    return texture;
}

osg::ref_ptr<const PaletteTextures> PassWorkspace::getPaletteTextures(const PaletteLookup& lookup) const
{
    const std::lock_guard lock(_mutex);
    if (!_paletteTextures || _paletteTextures->getLookup() != lookup) _paletteTextures = new PaletteTextures(lookup);
    return _paletteTextures;
}

void PassWorkspace::releaseTextures() const
{
    const std::lock_guard lock(_mutex);
    _textures.clear();
    _paletteTextures = nullptr;
}

void PassWorkspace::releaseGLObjects(osg::State* state) const
{
    // The map is copied to avoid a deadlock: a pass locks its context first, then the workspace.
    std::map<unsigned int, osg::ref_ptr<PassContext>> contexts;
    {
        const std::lock_guard lock(_mutex);
        for (const auto& [surface, texture] : _textures)
            texture->releaseGLObjects(state);
        if (_paletteTextures) _paletteTextures->releaseGLObjects(state);
        contexts = _contexts;
    }
    for (const auto& [contextID, context] : contexts)
    {
        if (state && state->getContextID() != contextID) continue;
        const std::lock_guard contextLock(context->mutex);
        context->work.reset();
    }
}

} // namespace osgLego
