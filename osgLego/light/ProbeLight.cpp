#include <osgLego/light/ProbeLight.h>

#include <osgLego/light/LatitudeLongitude.h>
#include <osgLego/light/ProbeFilter.h>
#include <osgLego/light/SkyModel.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

constexpr int WIDTH = ProbeFormat::CONVOLVED_WIDTH;
constexpr int HEIGHT = WIDTH / 2;

SphericalHarmonics::Coefficients project(const RadiancePicture& picture)
{
    SphericalHarmonics::Coefficients coefficients;
    picture.visit(
        [&](const RadiancePicture::Piece& piece)
        {
            const auto harmonics = SphericalHarmonics::evaluate(piece.direction);
            const osg::Vec3d flux = piece.radiance * piece.solidAngle;
            for (std::size_t index = 0; index < harmonics.size(); ++index)
                coefficients[index] += flux * harmonics[index];
        });
    return coefficients;
}

osg::Vec3d notBelowZero(const osg::Vec3d& color)
{
    return {std::max(color.x(), 0.0), std::max(color.y(), 0.0), std::max(color.z(), 0.0)};
}

double largestOf(const osg::Vec3d& color)
{
    return std::max({color.x(), color.y(), color.z()});
}

} // namespace

ProbeLight::ProbeLight(const RadiancePicture& picture) :
    _coefficients(project(picture)), _irradiancePolynomial(SphericalHarmonics::toIrradiancePolynomial(_coefficients))
{
    const RadianceGrid fine(picture, ProbeFormat::REFLECTION_WIDTH, ProbeFormat::REFLECTION_WIDTH / 2);
    const RadianceGrid coarse = fine.halved();
    _convolvedMap = convolveWithCosine(coarse);
    _reflectionMaps[0] = fine.createImage();
    for (int level = 1; level < ProbeFormat::REFLECTION_LEVELS; ++level)
    {
        const double roughness = static_cast<double>(level) / (ProbeFormat::REFLECTION_LEVELS - 1);
        _reflectionMaps[static_cast<std::size_t>(level)] =
            filterByRoughness(coarse, roughness, ProbeFormat::REFLECTION_WIDTH >> level);
    }
    _harmonicError = computeHarmonicError();
}

osg::ref_ptr<const ProbeLight> ProbeLight::create(const RadiancePicture& picture)
{
    return new ProbeLight(picture);
}

const ProbeLight& ProbeLight::getSky()
{
    static const osg::ref_ptr<const ProbeLight> sky = create(
        RadiancePicture::create(ProbeFormat::REFLECTION_WIDTH, ProbeFormat::REFLECTION_WIDTH / 2, computeSkyRadiance));
    return *sky;
}

osg::Vec3d ProbeLight::getHarmonicIrradiance(const osg::Vec3d& normal) const
{
    return notBelowZero(SphericalHarmonics::evaluatePolynomial(_irradiancePolynomial, normal));
}

osg::Vec3d ProbeLight::getConvolvedPixel(int column, int row) const
{
    if (row < 0 || row >= HEIGHT)
    {
        row = row < 0 ? 0 : HEIGHT - 1;
        column += WIDTH / 2;
    }
    column = (column + WIDTH) % WIDTH;
    return reinterpret_cast<const osg::Vec3f*>(_convolvedMap->data())[row * WIDTH + column];
}

osg::Vec3d ProbeLight::getConvolvedIrradiance(const osg::Vec3d& normal) const
{
    const osg::Vec2d place = LatitudeLongitude::coordinatesOf(normal);
    const double u = place.x() * WIDTH - 0.5;
    const double v = place.y() * HEIGHT - 0.5;
    const int column = static_cast<int>(std::floor(u));
    const int row = static_cast<int>(std::floor(v));
    const double right = u - column;
    const double up = v - row;
    const osg::Vec3d below =
        getConvolvedPixel(column, row) * (1.0 - right) + getConvolvedPixel(column + 1, row) * right;
    const osg::Vec3d above =
        getConvolvedPixel(column, row + 1) * (1.0 - right) + getConvolvedPixel(column + 1, row + 1) * right;
    return below * (1.0 - up) + above * up;
}

double ProbeLight::computeHarmonicError() const
{
    osg::Vec3d squares;
    osg::Vec3d sum;
    double total = 0.0;
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column)
        {
            const double weight = LatitudeLongitude::solidAngleOf(row, WIDTH, HEIGHT);
            const osg::Vec3d convolved = getConvolvedPixel(column, row);
            const osg::Vec3d difference =
                getHarmonicIrradiance(LatitudeLongitude::directionAt((column + 0.5) / WIDTH, (row + 0.5) / HEIGHT)) -
                convolved;
            squares += osg::componentMultiply(difference, difference) * weight;
            sum += convolved * weight;
            total += weight;
        }
    const double mean = largestOf(sum) / total;
    return mean > 0.0 ? std::sqrt(largestOf(squares) / total) / mean : 0.0;
}

} // namespace osgLego
