#include <osgLego/polygonization/DistantOcclusionView.h>

#include <osgLego/gl/ProgramUniforms.h>

namespace osgLego
{

DistantOcclusionView::DistantOcclusionView(DistantOcclusionTexture& occlusion, bool isExact,
                                           const osg::Matrixd& modelView, const osg::Matrixd& projection, double width,
                                           double share) :
    _occlusion(&occlusion),
    _share(static_cast<float>(share)), _includesNear(isExact && occlusion.includesNear())
{
    const osg::Matrixd cellsToEye = occlusion.getCellsToModel() * modelView;
    const glm::dvec3 scale(occlusion.getScale());
    const glm::dvec3 offset(occlusion.getOffset());
    _eyeToVoxels = toGlsl(osg::Matrixd::inverse(cellsToEye) * osg::Matrixd::scale(scale.x, scale.y, scale.z) *
                          osg::Matrixd::translate(offset.x, offset.y, offset.z));
    const double cell = osg::Matrixd::transform3x3(osg::Vec3d(1.0, 0.0, 0.0), cellsToEye).length();
    const double voxel = cell * occlusion.getVoxel().x / occlusion.getScale().x;
    _pixelWidth = 2.0 / (width * projection(0, 0) * voxel) * glm::dvec2(projection(3, 3), projection(2, 3));
}

void DistantOcclusionView::apply(osg::State& state) const
{
    static const UniformName EYE_TO_VOXELS("eyeToVoxels");
    static const UniformName SCALE("voxelScale");
    static const UniformName OFFSET("voxelOffset");
    static const UniformName VOXEL("voxel");
    static const UniformName PIXEL_WIDTH("pixelWidth");
    static const UniformName SHARE("distantShare");
    static const UniformName HAS_FACES("hasFaceOcclusion");
    static const UniformName INCLUDES_NEAR("includesNear");
    state.applyTextureAttribute(MEAN_UNIT, &_occlusion->getMean());
    state.applyTextureAttribute(BEND_UNIT, &_occlusion->getBend());
    const ProgramUniforms uniforms(state);
    uniforms.set(EYE_TO_VOXELS, _eyeToVoxels);
    uniforms.set(SCALE, _occlusion->getScale());
    uniforms.set(OFFSET, _occlusion->getOffset());
    uniforms.set(VOXEL, _occlusion->getVoxel());
    uniforms.set(PIXEL_WIDTH, _pixelWidth);
    uniforms.set(SHARE, _share);
    uniforms.set(HAS_FACES, _occlusion->includesNear() ? 1 : 0);
    uniforms.set(INCLUDES_NEAR, _includesNear ? 1 : 0);
}

} // namespace osgLego
