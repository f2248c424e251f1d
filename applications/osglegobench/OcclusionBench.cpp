#include "OcclusionBench.h"

#include "BenchView.h"
#include "Spread.h"

#include <common/BrickRayCaster.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

constexpr glm::ivec2 PICTURE_SIZE(1280, 720);

/** What a pixel is compared by. */
struct Sample
{
    double visibility;
    glm::dvec3 bentNormal; // in the model's coordinates
};

glm::dvec3 toGlm(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/** A direction as AmbientOcclusionOutput has it, in the model's coordinates. */
glm::dvec3 readDirection(const BenchView& view, const osg::Image& image, const glm::ivec2& pixel)
{
    const osg::Vec4 color = image.getColor(static_cast<unsigned int>(pixel.x), static_cast<unsigned int>(pixel.y));
    const osg::Vec3d eye = osg::Vec3d(color.r(), color.g(), color.b()) * 2.0 - osg::Vec3d(1, 1, 1);
    return glm::normalize(toGlm(view.toModel(eye)));
}

/** Adds up what two ways of computing occlusion say of pixels. */
class Comparison
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
        _angles.push_back(std::acos(cosine) * 180.0 / std::numbers::pi);

        const double lit = irradianceOf(rays);
        const double difference = irradianceOf(screen) - lit;
        _irradiance += lit;
        _irradianceSquares += difference * difference;
    }

    OcclusionError finish()
    {
        OcclusionError result;
        const auto count = static_cast<double>(_angles.size());
        result.numPixels = _angles.size();
        if (_angles.empty()) return result;
        result.rootMeanSquare = std::sqrt(_squares / count);
        result.mean = _sum / count;
        const double mean = _visibility / count;
        result.constant = std::sqrt(std::max(_visibilitySquares / count - mean * mean, 0.0));
        for (const double angle : _angles)
            result.bentMean += angle / count;
        std::sort(_angles.begin(), _angles.end());
        result.bentMost = _angles[static_cast<std::size_t>(0.95 * (count - 1.0))];
        result.irradiance = std::sqrt(_irradianceSquares / count) / (_irradiance / count);
        return result;
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
    std::vector<double> _angles;
};

} // namespace

OcclusionError measureOcclusion(const BenchScene& scene, AmbientOcclusionQuality quality, int numRays, int stride)
{
    BenchView view(scene, PICTURE_SIZE);
    AmbientOcclusionSettings settings;
    settings.quality = quality;
    const auto draw = [&](AmbientOcclusionOutput output)
    {
        settings.output = output;
        return view.draw(settings);
    };
    const osg::ref_ptr<osg::Image> occlusion = draw(AmbientOcclusionOutput::OCCLUSION);
    const osg::ref_ptr<osg::Image> bent = draw(AmbientOcclusionOutput::BENT_NORMALS);
    const osg::ref_ptr<osg::Image> normals = draw(AmbientOcclusionOutput::NORMALS);

    const BrickRayCaster caster(*view.getLegoNode().getBricks());
    Comparison comparison;
    for (int y = stride / 2; y < PICTURE_SIZE.y; y += stride)
        for (int x = stride / 2; x < PICTURE_SIZE.x; x += stride)
        {
            const osg::Vec4 shown = occlusion->getColor(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
            osg::Vec3d origin;
            osg::Vec3d direction;
            view.getRay({x, y}, origin, direction);
            const auto distance = caster.findNearest(caster.toCaster(origin), toGlm(direction), 1e9);
            // Where the bricks' edges are rounded to another pixel than the ray's there is nothing to compare.
            if (!distance || shown.a() == 0.0f) continue;
            const glm::dvec3 point = caster.toCaster(origin) + *distance * toGlm(direction);
            const glm::dvec3 normal = readDirection(view, *normals, {x, y});
            const BrickRayCaster::Occlusion rays = caster.sampleOcclusion(
                point, normal, AmbientOcclusionSettings::RADIUS_IN_BRICKS, AmbientOcclusionSettings::FALLOFF, numRays,
                static_cast<std::uint32_t>(y * PICTURE_SIZE.x + x));
            comparison.add({shown.r(), readDirection(view, *bent, {x, y})}, {rays.visibility, rays.bentNormal});
        }
    return comparison.finish();
}

AmbientOcclusionTimes measureOcclusionTimes(const BenchScene& scene, AmbientOcclusionQuality quality, int width,
                                            int height, int numFrames)
{
    BenchView view(scene, {width, height});
    AmbientOcclusionSettings settings;
    settings.quality = quality;
    view.draw(settings); // legolizes, and makes what is made once
    view.getScene().setTiming(true);
    constexpr std::array PASSES{&AmbientOcclusionTimes::geometry, &AmbientOcclusionTimes::resolve,
                                &AmbientOcclusionTimes::occlusion, &AmbientOcclusionTimes::denoise,
                                &AmbientOcclusionTimes::composite};
    std::array<std::vector<double>, PASSES.size()> all;
    for (int frame = 0; frame < numFrames; ++frame)
    {
        view.draw(settings);
        const AmbientOcclusionTimes times = view.getTimes();
        for (std::size_t pass = 0; pass < PASSES.size(); ++pass)
            all[pass].push_back(times.*PASSES[pass]);
    }
    AmbientOcclusionTimes medians;
    for (std::size_t pass = 0; pass < PASSES.size(); ++pass)
        medians.*PASSES[pass] = Spread::create(all[pass]).median;
    return medians;
}

std::vector<BenchScene> createOcclusionScenes(const std::string& modelFolder)
{
    const auto settingsOf = [](unsigned int resolution, UpAxis up)
    {
        LegoSettings settings;
        settings.resolution = resolution;
        settings.upAxis = up;
        return settings;
    };
    std::vector<BenchScene> scenes;
    for (const auto& [azimuth, elevation] : {std::pair{30.0, 25.0}, {150.0, 40.0}, {260.0, 10.0}})
    {
        const std::string bunny = modelFolder + "/bunny.ply";
        if (std::filesystem::exists(bunny))
            scenes.push_back({"bunny 64", bunny, settingsOf(64, UpAxis::Y), azimuth, elevation});
        else if (scenes.empty())
            fmt::print("without the bunny: there is no '{}'\n", bunny);
        scenes.push_back({"car 32", "", settingsOf(32, UpAxis::Z), azimuth, elevation});
        scenes.push_back({"stair 10", "stair", settingsOf(10, UpAxis::Z), azimuth, elevation});
    }
    return scenes;
}

} // namespace osgLego
