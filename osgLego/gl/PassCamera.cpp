#include <osgLego/gl/PassCamera.h>

#include <osg/NodeVisitor>
#include <osg/Viewport>

namespace osgLego
{

PassCamera::PassCamera(const osg::Drawable& drawable, osg::Texture2D& target, const osg::Vec4& clearColor) :
    PassCamera(drawable, std::vector<osg::ref_ptr<osg::Texture2D>>{&target}, clearColor)
{
}

PassCamera::PassCamera(const osg::Drawable& drawable, const std::vector<osg::ref_ptr<osg::Texture2D>>& targets,
                       const osg::Vec4& clearColor) :
    _drawable(drawable)
{
    if (targets.size() == 1)
        attach(COLOR_BUFFER, targets.front());
    else
        for (std::size_t index = 0; index < targets.size(); ++index)
            attach(static_cast<BufferComponent>(COLOR_BUFFER0 + index), targets[index]);
    setUp({targets.front()->getTextureWidth(), targets.front()->getTextureHeight()});
    setClearColor(clearColor);
    setClearMask(GL_COLOR_BUFFER_BIT);
}

PassCamera::PassCamera(const osg::Drawable& drawable) : _drawable(drawable)
{
    attach(COLOR_BUFFER, GL_RGBA8);
    setUp({1, 1});
    setClearMask(0);
}

void PassCamera::setUp(const glm::ivec2& size)
{
    setRenderOrder(PRE_RENDER);
    setRenderTargetImplementation(FRAME_BUFFER_OBJECT);
    setImplicitBufferAttachmentMask(0, 0);
    setReferenceFrame(ABSOLUTE_RF);
    setViewport(0, 0, size.x, size.y);
    setColorMask(true, true, true, true);
    setCullingMode(NO_CULLING);
    setComputeNearFarMode(DO_NOT_COMPUTE_NEAR_FAR);
    setCullMask(~0u);
    setInheritanceMask(getInheritanceMask() & ~(CULL_MASK | COMPUTE_NEAR_FAR_MODE | CULLING_MODE));
    setCullingActive(false);
    setAllowEventFocus(false);
}

void PassCamera::addDepthBuffer()
{
    attach(DEPTH_BUFFER, GL_DEPTH_COMPONENT24);
    clearDepthBuffer();
}

void PassCamera::addDepthBuffer(osg::Texture2D& target)
{
    attach(DEPTH_BUFFER, &target);
    clearDepthBuffer();
}

void PassCamera::clearDepthBuffer()
{
    setClearDepth(1.0);
    setClearMask(getClearMask() | GL_DEPTH_BUFFER_BIT);
}

void PassCamera::traverse(osg::NodeVisitor& visitor)
{
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR)
        const_cast<osg::Drawable&>(_drawable).accept(visitor);
}

osg::ref_ptr<osg::Texture2D> PassCamera::createTarget(const glm::ivec2& size, GLint internalFormat)
{
    return createTexture(size, internalFormat, GL_RGBA);
}

osg::ref_ptr<osg::Texture2D> PassCamera::createDepthTarget(const glm::ivec2& size)
{
    return createTexture(size, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT);
}

osg::ref_ptr<osg::Texture2D> PassCamera::createTexture(const glm::ivec2& size, GLint internalFormat, GLenum format)
{
    osg::ref_ptr<osg::Texture2D> target = new osg::Texture2D;
    target->setTextureSize(size.x, size.y);
    target->setInternalFormat(internalFormat);
    target->setSourceFormat(format);
    target->setSourceType(GL_FLOAT);
    target->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    target->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    target->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    target->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return target;
}

} // namespace osgLego
