#include "OcclusionView.h"

#include "Spread.h"

#include <osgLego/data/DistantOcclusion.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

glm::dvec3 toGlm(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

osg::Vec4 getColor(const osg::Image& image, const glm::ivec2& pixel)
{
    return image.getColor(static_cast<unsigned int>(pixel.x), static_cast<unsigned int>(pixel.y));
}

/** Visibility (0 to 1) and bent normal of a pixel, computed by one of the two methods. */
struct Sample
{
    double visibility;
    glm::dvec3 bentNormal;
};

/** The error of screen-space ambient occlusion, accumulated pixel by pixel. */
class OcclusionError
{
public:
    void add(const Sample& screen, const Sample& rays)
    {
        const double error = screen.visibility - rays.visibility;
        _sum += error;
        _squares += error * error;
        _visibility += rays.visibility;
        _visibilitySquares += rays.visibility * rays.visibility;
        const double cosine = std::clamp(glm::dot(screen.bentNormal, rays.bentNormal), -1.0, 1.0);
        _angles.push_back(osg::RadiansToDegrees(std::acos(cosine)));
        const double lit = irradianceOf(rays);
        const double difference = irradianceOf(screen) - lit;
        _irradiance += lit;
        _irradianceSquares += difference * difference;
    }

    JsonValue toJson()
    {
        if (_angles.empty()) throw std::runtime_error("no pixel shows a brick");
        const auto count = static_cast<double>(_angles.size());
        const double mean = _visibility / count;
        std::sort(_angles.begin(), _angles.end());
        return {{"pixels", _angles.size()},
                {"rootMeanSquare", std::sqrt(_squares / count)},
                {"mean", _sum / count},
                {"constant", std::sqrt(std::max(_visibilitySquares / count - mean * mean, 0.0))},
                {"bentMean", std::accumulate(_angles.begin(), _angles.end(), 0.0) / count},
                {"bentMost", getQuantile(_angles, 0.95)},
                {"irradiance", std::sqrt(_irradianceSquares / count) / (_irradiance / count)}};
    }

private:
    double irradianceOf(const Sample& sample) const
    {
        const osg::Vec3d light =
            _probe->getIrradiance(osg::Vec3d(sample.bentNormal.x, sample.bentNormal.y, sample.bentNormal.z));
        return sample.visibility * (light.x() + light.y() + light.z()) / 3.0;
    }

    osg::ref_ptr<LightProbe> _probe = new LightProbe;
    double _sum = 0.0;
    double _squares = 0.0;
    double _visibility = 0.0;
    double _visibilitySquares = 0.0;
    double _irradiance = 0.0;
    double _irradianceSquares = 0.0;
    std::vector<double> _angles; // degrees
};

} // namespace

OcclusionView::OcclusionView(const BenchScene& scene, BrickOcclusion occlusion, const glm::ivec2& size) :
    _size(size), _viewer(glm::ivec2(16, 16)), _lego(scene.createLego(occlusion))
{
    _occlusion->addChild(_lego);
    _occlusion->setTiming(true);
    _image->allocateImage(size.x, size.y, 1, GL_RGBA, GL_FLOAT);
    _image->setInternalTextureFormat(GL_RGBA32F_ARB);
    _camera->setRenderOrder(osg::Camera::PRE_RENDER);
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->attach(osg::Camera::COLOR_BUFFER, _image);
    _camera->setViewport(0, 0, size.x, size.y);
    _camera->setClearColor(osg::Vec4());
    _camera->setCullingMode(osg::CullSettings::NO_CULLING);
    _camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    _camera->addChild(_occlusion);
    _viewer.show(*_camera, scene);
    scene.placeCamera(*_camera, _lego->getBound(), size);
}

osg::ref_ptr<osg::Image> OcclusionView::draw(const AmbientOcclusionSettings& settings)
{
    _occlusion->setSettings(settings);
    _viewer.timeFrame();
    checkBricks(*_lego, _viewer);
    checkPicture(*_image);
    return new osg::Image(*_image, osg::CopyOp::DEEP_COPY_ALL);
}

OcclusionView::Ray OcclusionView::getRay(const glm::ivec2& pixel) const
{
    const osg::Matrixd toModel = osg::Matrixd::inverse(_camera->getViewMatrix() * _camera->getProjectionMatrix());
    const double x = 2.0 * (pixel.x + 0.5) / _size.x - 1.0;
    const double y = 2.0 * (pixel.y + 0.5) / _size.y - 1.0;
    const glm::dvec3 origin = toGlm(osg::Vec3d(x, y, -1.0) * toModel);
    return {origin, glm::normalize(toGlm(osg::Vec3d(x, y, 1.0) * toModel) - origin)};
}

/** Decode a direction written by AmbientOcclusionOutput and convert it to model coordinates. */
glm::dvec3 OcclusionView::readDirection(const osg::Image& image, const glm::ivec2& pixel) const
{
    const osg::Vec4 color = getColor(image, pixel);
    const osg::Vec3d eye = osg::Vec3d(color.r(), color.g(), color.b()) * 2.0 - osg::Vec3d(1, 1, 1);
    return glm::normalize(toGlm(osg::Matrixd::transform3x3(eye, _camera->getInverseViewMatrix())));
}

/** Cast rays from the points shown by pixels, one of `stride` * `stride`. */
void OcclusionView::castRays(const AmbientOcclusionSettings& settings, int numRays, int stride,
                             const Compared& compared)
{
    AmbientOcclusionSettings output = settings;
    output.output = AmbientOcclusionOutput::NORMALS;
    const osg::ref_ptr<osg::Image> normals = draw(output);
    const BrickRayCaster caster(*_lego->getBricks());
    const double reach = settings.hasDistant() ? DistantOcclusion::getReach(caster.getModel().getGrid())
                                               : AmbientOcclusionSettings::RADIUS_IN_BRICKS;
    glm::ivec2 pixel;
    for (pixel.y = stride / 2; pixel.y < _size.y; pixel.y += stride)
        for (pixel.x = stride / 2; pixel.x < _size.x; pixel.x += stride)
        {
            const Ray ray = getRay(pixel);
            const glm::dvec3 origin = caster.toCaster(osg::Vec3d(ray.origin.x, ray.origin.y, ray.origin.z));
            const auto distance = caster.findNearest(origin, ray.direction, 1e9);
            // At silhouettes, the picture and the ray may disagree on whether a pixel shows bricks.
            if (!distance || getColor(*normals, pixel).a() == 0.0f) continue;
            compared(pixel, caster.sampleOcclusion(origin + *distance * ray.direction, readDirection(*normals, pixel),
                                                   reach, AmbientOcclusionSettings::FALLOFF, numRays,
                                                   static_cast<std::uint32_t>(pixel.y * _size.x + pixel.x)));
        }
}

JsonValue OcclusionView::compare(AmbientOcclusionSettings settings, int numRays, int stride)
{
    settings.output = AmbientOcclusionOutput::OCCLUSION;
    const osg::ref_ptr<osg::Image> occlusion = draw(settings);
    settings.output = AmbientOcclusionOutput::BENT_NORMALS;
    const osg::ref_ptr<osg::Image> bent = draw(settings);
    OcclusionError error;
    castRays(settings, numRays, stride,
             [&](const glm::ivec2& pixel, const BrickRayCaster::Occlusion& rays) {
                 error.add({getColor(*occlusion, pixel).r(), readDirection(*bent, pixel)},
                           {rays.visibility, rays.bentNormal});
             });
    return error.toJson();
}

osg::ref_ptr<osg::Image> OcclusionView::drawByRays(const AmbientOcclusionSettings& settings, int numRays)
{
    const osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(_size.x, _size.y, 1, GL_RGBA, GL_FLOAT);
    std::fill_n(reinterpret_cast<float*>(picture->data()), 4 * _size.x * _size.y, 0.0f);
    castRays(settings, numRays, 1,
             [&](const glm::ivec2& pixel, const BrickRayCaster::Occlusion& rays)
             {
                 const auto grey = static_cast<float>(rays.visibility);
                 picture->setColor(osg::Vec4(grey, grey, grey, 1.0f), static_cast<unsigned int>(pixel.x),
                                   static_cast<unsigned int>(pixel.y));
             });
    return picture;
}

} // namespace osgLego
