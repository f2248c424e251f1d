#include "LookTest.h"

#include "Settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <osg/Geode>
#include <osg/Shape>
#include <osg/ShapeDrawable>

namespace osgLego::test
{

void Viewpoint::apply(osg::Camera& camera) const
{
    const double aspect = camera.getViewport()->width() / camera.getViewport()->height();
    camera.setViewMatrixAsLookAt(eye, target, up);
    if (height > 0.0)
        camera.setProjectionMatrixAsOrtho(-0.5 * aspect * height, 0.5 * aspect * height, -0.5 * height, 0.5 * height,
                                          0.1, 1000.0);
    else
        camera.setProjectionMatrixAsPerspective(30.0, aspect, 0.1, 1000.0);
}

void LookTest::SetUp()
{
    GlTest::SetUp();
    _context = createContext();
    setUpViewer(_viewer, *_context, *osg::ref_ptr<osg::Group>(new osg::Group));
}

osg::ref_ptr<osg::Image> LookTest::draw(osg::Node& scene, const Viewpoint& viewpoint)
{
    viewpoint.apply(*_viewer.getCamera());
    if (_viewer.getSceneData() != &scene) _viewer.setSceneData(&scene);
    _viewer.frame();
    return readPixels(*_context);
}

osg::Vec3d LookTest::pixelOf(const osg::Vec3d& place) const
{
    const osg::Camera& camera = *_viewer.getCamera();
    return place * camera.getViewMatrix() * camera.getProjectionMatrix() * camera.getViewport()->computeWindowMatrix();
}

osg::Vec3d LookTest::colorAt(const osg::Image& image, const osg::Vec3d& place) const
{
    const osg::Vec3d pixel = pixelOf(place);
    const auto column = static_cast<int>(pixel.x());
    const auto row = static_cast<int>(pixel.y());
    osg::Vec3d sum;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += readColor(image, std::clamp(column + x, 0, image.s() - 1), std::clamp(row + y, 0, image.t() - 1));
    return sum / 9.0;
}

AmbientOcclusionSettings parseOcclusion(const std::string& text)
{
    AmbientOcclusionSettings settings;
    std::string error;
    EXPECT_TRUE(AmbientOcclusionSettings::parse(text, settings, error)) << error;
    return settings;
}

osg::ref_ptr<AmbientOcclusionScene> createGroup(const std::string& settings, osg::Node* child)
{
    osg::ref_ptr<AmbientOcclusionScene> group = new AmbientOcclusionScene;
    group->setSettings(parseOcclusion(settings));
    if (child) group->addChild(child);
    return group;
}

osg::ref_ptr<LegoNode> createBrickBox(const osg::Vec3& size, const std::string& settings, const osg::Vec4& color)
{
    osg::ref_ptr<osg::ShapeDrawable> box =
        new osg::ShapeDrawable(new osg::Box(size * 0.5f, size.x(), size.y(), size.z()));
    box->setColor(color);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(box);
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
    lego->addChild(geode);
    return lego;
}

osg::ref_ptr<osg::Geometry> createQuad(const osg::Vec3& corner, const osg::Vec3& across, const osg::Vec3& up,
                                       const osg::Vec4& color)
{
    osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(corner, across, up);
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    colors->push_back(color);
    quad->setColorArray(colors, osg::Array::BIND_OVERALL);
    return quad;
}

osg::ref_ptr<LightProbe> createDarkProbe()
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    probe->setIntensity(0.0);
    return probe;
}

osg::Vec3d readColor(const osg::Image& image, int column, int row)
{
    const osg::Vec4 color = image.getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
    return {color.r(), color.g(), color.b()};
}

double brightnessAt(const osg::Image& image, int column, int row)
{
    const osg::Vec3d color = readColor(image, column, row);
    return (color.x() + color.y() + color.z()) / 3.0;
}

double meanBrightness(const osg::Image& image)
{
    double sum = 0.0;
    for (int row = 0; row < image.t(); ++row)
        for (int column = 0; column < image.s(); ++column)
            sum += brightnessAt(image, column, row);
    return sum / (image.s() * image.t());
}

double stepBetweenPixels(const osg::Image& image)
{
    constexpr int MARGIN = 5;
    double squares = 0.0;
    for (int row = 0; row < image.t(); ++row)
        for (int column = MARGIN; column < image.s() - MARGIN; ++column)
        {
            const double step = brightnessAt(image, column, row) - brightnessAt(image, column - 1, row);
            squares += step * step;
        }
    return std::sqrt(squares / (image.t() * (image.s() - 2 * MARGIN)));
}

double meanDifference(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int row = 0; row < a.t(); ++row)
        for (int column = 0; column < a.s(); ++column)
        {
            const osg::Vec3d difference = readColor(a, column, row) - readColor(b, column, row);
            sum += std::abs(difference.x()) + std::abs(difference.y()) + std::abs(difference.z());
        }
    return 255.0 * sum / (3.0 * a.s() * a.t());
}

} // namespace osgLego::test
