#include <common/RacingCar.h>

#include <common/RacingCarLivery.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include <osg/CopyOp>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Texture2D>
#include <osgUtil/SmoothingVisitor>

namespace osgLego
{

namespace
{

constexpr double PI = std::numbers::pi;
constexpr double CREASE_ANGLE = 0.7;
constexpr double NOSE = -2.15;
constexpr double TAIL = 2.05;

using Ring = std::vector<osg::Vec3d>;
using ColorOf = std::function<osg::Vec4(std::size_t ring, std::size_t corner)>;

/** A cross-section of the body. */
struct Section
{
    double x;
    double halfWidth;
    double bottom;
    double top;
    double roundness; // the exponent of a superellipse: 2 is an ellipse, more is boxier
};

Ring ringOf(const Section& section, std::size_t corners)
{
    Ring ring;
    const double middle = 0.5 * (section.bottom + section.top);
    const double halfHeight = 0.5 * (section.top - section.bottom);
    const auto powered = [&](double value)
    { return std::copysign(std::pow(std::abs(value), 2.0 / section.roundness), value); };
    for (std::size_t corner = 0; corner < corners; ++corner)
    {
        const double angle = 2.0 * PI * static_cast<double>(corner) / static_cast<double>(corners);
        ring.emplace_back(section.x, section.halfWidth * powered(std::cos(angle)),
                          middle + halfHeight * powered(std::sin(angle)));
    }
    return ring;
}

/** Whether a surface through rings is open at the first and last ring, or closed by triangle fans. */
enum class Ends
{
    OPEN,
    CLOSED
};

/** A surface through rings that have the same number of corners. */
osg::ref_ptr<osg::Geometry> createLoft(const std::vector<Ring>& rings, const ColorOf& colorOf, Ends ends = Ends::CLOSED)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    const std::size_t corners = rings.front().size();
    for (std::size_t ring = 0; ring < rings.size(); ++ring)
        for (std::size_t corner = 0; corner < corners; ++corner)
        {
            vertices->push_back(rings[ring][corner]);
            colors->push_back(colorOf(ring, corner));
        }
    const auto indexOf = [&](std::size_t ring, std::size_t corner)
    { return static_cast<unsigned int>(ring * corners + corner % corners); };
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring)
        for (std::size_t corner = 0; corner < corners; ++corner)
            for (const unsigned int index :
                 {indexOf(ring, corner), indexOf(ring, corner + 1), indexOf(ring + 1, corner),
                  indexOf(ring + 1, corner), indexOf(ring, corner + 1), indexOf(ring + 1, corner + 1)})
                triangles->push_back(index);
    for (std::size_t corner = 1; ends == Ends::CLOSED && corner + 1 < corners; ++corner)
    {
        const std::size_t last = rings.size() - 1;
        for (const unsigned int index : {indexOf(0, 0), indexOf(0, corner + 1), indexOf(0, corner), indexOf(last, 0),
                                         indexOf(last, corner), indexOf(last, corner + 1)})
            triangles->push_back(index);
    }

    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(triangles);
    return geometry;
}

ColorOf plain(const osg::Vec4& color)
{
    return [color](std::size_t, std::size_t) { return color; };
}

/** A surface of revolution around the y axis. @param profile y and radius of each ring. */
osg::ref_ptr<osg::Geometry> createLathe(const std::vector<osg::Vec2d>& profile, std::size_t corners,
                                        const ColorOf& colorOf, Ends ends)
{
    std::vector<Ring> rings;
    for (const osg::Vec2d& place : profile)
    {
        Ring ring;
        ring.reserve(corners);
        for (std::size_t corner = 0; corner < corners; ++corner)
        {
            const double angle = 2.0 * PI * static_cast<double>(corner) / static_cast<double>(corners);
            ring.emplace_back(place.y() * std::sin(angle), place.x(), place.y() * std::cos(angle));
        }
        rings.push_back(ring);
    }
    return createLoft(rings, colorOf, ends);
}

osg::ref_ptr<osg::Geometry> createBox(const osg::Vec3d& low, const osg::Vec3d& high, const osg::Vec4& color)
{
    std::vector<Ring> rings;
    for (const double x : {low.x(), high.x()})
        rings.push_back(
            {{x, low.y(), high.z()}, {x, low.y(), low.z()}, {x, high.y(), low.z()}, {x, high.y(), high.z()}});
    return createLoft(rings, plain(color));
}

void smooth(osg::Geometry& geometry)
{
    osgUtil::SmoothingVisitor::smooth(geometry, CREASE_ANGLE);
}

void setMaterial(osg::Node& node, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, color);
    material->setAmbient(osg::Material::FRONT_AND_BACK, color);
    material->setSpecular(osg::Material::FRONT_AND_BACK, osg::Vec4(0.3f, 0.3f, 0.3f, 1.0f));
    material->setShininess(osg::Material::FRONT_AND_BACK, 32.0f);
    node.getOrCreateStateSet()->setAttributeAndModes(material);
}

void setTexture(osg::Geometry& geometry, osg::Image* image, const osg::Vec3d& low, const osg::Vec3d& high)
{
    osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (const osg::Vec3& vertex : static_cast<osg::Vec3Array&>(*geometry.getVertexArray()))
        coordinates->push_back(
            osg::Vec2d((vertex.x() - low.x()) / (high.x() - low.x()), (vertex.y() - low.y()) / (high.y() - low.y())));
    geometry.setTexCoordArray(0, coordinates);

    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    geometry.getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
}

osg::ref_ptr<osg::Node> createBody()
{
    constexpr std::size_t CORNERS = 32;
    const std::vector<Section> sections{
        {NOSE, 0.06, 0.27, 0.36, 2.0},  {-2.10, 0.13, 0.23, 0.41, 2.2}, {-1.90, 0.20, 0.19, 0.47, 2.4},
        {-1.40, 0.27, 0.16, 0.55, 2.5}, {-0.80, 0.36, 0.14, 0.62, 2.6}, {-0.30, 0.45, 0.13, 0.66, 2.8},
        {0.10, 0.49, 0.13, 0.66, 3.0},  {0.50, 0.50, 0.13, 0.66, 3.0},  {0.90, 0.48, 0.13, 0.70, 2.8},
        {1.35, 0.42, 0.15, 0.66, 2.6},  {1.75, 0.32, 0.19, 0.58, 2.4},  {TAIL, 0.20, 0.26, 0.50, 2.2}};
    std::vector<Ring> rings;
    rings.reserve(sections.size());
    for (const Section& section : sections)
        rings.push_back(ringOf(section, CORNERS));
    osg::ref_ptr<osg::Geometry> body = createLoft(rings, plain(osg::Vec4(1, 1, 1, 1)));
    setTexture(*body, getRacingCarLivery(), osg::Vec3d(NOSE, -0.5, 0), osg::Vec3d(TAIL, 0.5, 0));
    smooth(*body);

    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("body");
    geode->addDrawable(body);
    return geode;
}

osg::ref_ptr<osg::Node> createCockpit()
{
    constexpr std::size_t CORNERS = 24;
    const osg::Vec4 black(0.06f, 0.06f, 0.07f, 1.0f);
    const osg::Vec4 yellow(0.98f, 0.80f, 0.08f, 1.0f);
    const osg::Vec4 glass(0.45f, 0.75f, 0.90f, 1.0f);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("cockpit");

    // A dark opening, a windscreen in front of it, a fairing behind it, and the driver's helmet.
    const auto ring = [](double x, double halfWidth, double bottom, double top) {
        return ringOf({x, halfWidth, bottom, top, 2.4}, CORNERS);
    };
    geode->addDrawable(createLoft(
        {ring(-0.18, 0.20, 0.55, 0.69), ring(0.10, 0.27, 0.55, 0.71), ring(0.48, 0.26, 0.55, 0.71)}, plain(black)));
    geode->addDrawable(createLoft(
        {ring(-0.42, 0.10, 0.58, 0.66), ring(-0.28, 0.22, 0.58, 0.78), ring(-0.18, 0.25, 0.58, 0.84)}, plain(glass)));
    geode->addDrawable(
        createLoft({ring(0.46, 0.17, 0.58, 0.92), ring(0.65, 0.16, 0.58, 0.89), ring(0.95, 0.11, 0.58, 0.74)},
                   plain(osg::Vec4(0.80f, 0.10f, 0.11f, 1.0f))));

    std::vector<Ring> helmet;
    for (int step = 0; step <= 12; ++step)
    {
        const double angle = PI * (step + 0.02) / 12.04;
        const double radius = 0.17 * std::sin(angle);
        helmet.push_back(ringOf({0.22 - 0.18 * std::cos(angle), radius, 0.88 - radius, 0.88 + radius, 2.0}, CORNERS));
    }
    geode->addDrawable(createLoft(helmet,
                                  [&](std::size_t step, std::size_t corner)
                                  {
                                      const osg::Vec3d& place = helmet[step][corner];
                                      const bool isVisor = place.x() < 0.20 && std::abs(place.z() - 0.89) < 0.055;
                                      return isVisor ? black : yellow;
                                  }));
    for (unsigned int index = 0; index < geode->getNumDrawables(); ++index)
        smooth(*geode->getDrawable(index)->asGeometry());
    return geode;
}

/** A tyre around the origin, its axle along y, its outer side towards +y. */
osg::ref_ptr<osg::Node> createTyre(double radius, double width)
{
    const osg::Vec4 rubber(0.09f, 0.09f, 0.10f, 1.0f);
    const osg::Vec4 stripe(0.85f, 0.12f, 0.12f, 1.0f);
    const double half = 0.5 * width;
    osg::ref_ptr<osg::Geometry> tyre = createLathe(
        {{-half, 0.62 * radius},
         {-half, 0.80 * radius},
         {-0.85 * half, 0.95 * radius},
         {-0.55 * half, radius},
         {0.55 * half, radius},
         {0.85 * half, 0.95 * radius},
         {half, 0.80 * radius},
         {half, 0.62 * radius}},
        36, [=](std::size_t ring, std::size_t) { return ring >= 6 ? stripe : rubber; }, Ends::OPEN);
    smooth(*tyre);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("tyre");
    geode->addDrawable(tyre);
    return geode;
}

osg::ref_ptr<osg::Node> createRim(double radius, double width)
{
    const double half = 0.5 * width;
    osg::ref_ptr<osg::Geometry> rim = createLathe({{-half, 0.60 * radius},
                                                   {half + 0.01, 0.60 * radius},
                                                   {half + 0.02, 0.20 * radius},
                                                   {half + 0.07, 0.14 * radius}},
                                                  24, plain(osg::Vec4(1, 1, 1, 1)), Ends::CLOSED);
    smooth(*rim);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("rim");
    geode->addDrawable(rim);
    setMaterial(*geode, osg::Vec4(0.83f, 0.70f, 0.30f, 1.0f));
    return geode;
}

osg::ref_ptr<osg::Node> createWheels()
{
    osg::ref_ptr<osg::Group> wheels = new osg::Group;
    wheels->setName("wheels");
    struct Axle
    {
        double x;
        double track;
        double radius;
        double width;
    };
    for (const Axle& axle : {Axle{-1.30, 0.78, 0.33, 0.30}, Axle{1.30, 0.80, 0.40, 0.44}})
    {
        osg::ref_ptr<osg::Group> wheel = new osg::Group;
        wheel->addChild(createTyre(axle.radius, axle.width));
        wheel->addChild(createRim(axle.radius, axle.width));
        for (const bool isLeft : {true, false})
        {
            osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(
                osg::Matrixd::rotate(isLeft ? 0.0 : PI, osg::Vec3d(0, 0, 1)) *
                osg::Matrixd::translate(axle.x, isLeft ? axle.track : -axle.track, axle.radius));
            place->addChild(wheel);
            wheels->addChild(place);
        }
    }
    return wheels;
}

osg::ref_ptr<osg::Node> createMetalParts()
{
    const osg::Vec4 white(1, 1, 1, 1);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("axles and pipes");
    for (const double x : {-1.30, 1.30})
    {
        const double z = x < 0.0 ? 0.33 : 0.40;
        geode->addDrawable(createBox({x - 0.045, -0.70, z - 0.045}, {x + 0.045, 0.70, z + 0.045}, white));
    }
    for (const double side : {-1.0, 1.0})
    {
        std::vector<Ring> pipe;
        for (const double x : {0.75, 1.0, 1.6, 2.2})
        {
            Ring ring = ringOf({x, 0.055, 0.0, 0.11, 2.0}, 12);
            const double out = x < 0.9 ? 0.36 : 0.50 - 0.10 * (x - 1.0);
            for (osg::Vec3d& corner : ring)
                corner += osg::Vec3d(0.0, side * out, 0.56);
            pipe.push_back(ring);
        }
        geode->addDrawable(createLoft(pipe, plain(white)));
    }
    for (unsigned int index = 0; index < geode->getNumDrawables(); ++index)
        smooth(*geode->getDrawable(index)->asGeometry());
    setMaterial(*geode, osg::Vec4(0.72f, 0.74f, 0.78f, 1.0f));
    return geode;
}

osg::ref_ptr<osg::Node> createWings()
{
    const osg::Vec4 white(1, 1, 1, 1);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("wings");
    geode->addDrawable(createBox({-2.12, -0.72, 0.20}, {-1.80, 0.72, 0.26}, white));
    for (const double side : {-1.0, 1.0})
    {
        const double low = std::min(side * 0.72, side * 0.78);
        geode->addDrawable(createBox({-2.15, low, 0.14}, {-1.78, low + 0.06, 0.40}, white));
        const double strut = std::min(side * 0.34, side * 0.40);
        geode->addDrawable(createBox({1.72, strut, 0.45}, {1.86, strut + 0.06, 1.02}, white));
    }
    setMaterial(*geode, osg::Vec4(0.07f, 0.25f, 0.56f, 1.0f));
    for (unsigned int index = 0; index < geode->getNumDrawables(); ++index)
        smooth(*geode->getDrawable(index)->asGeometry());

    const osg::Vec3d low(1.62, -0.66, 1.02);
    const osg::Vec3d high(2.08, 0.66, 1.09);
    osg::ref_ptr<osg::Geometry> rear = createBox(low, high, white);
    // The flag runs across: its s is the car's y.
    setTexture(*rear, getChequeredFlag(), low, high);
    for (osg::Vec2& coordinate : static_cast<osg::Vec2Array&>(*rear->getTexCoordArray(0)))
        coordinate.set(coordinate.y(), coordinate.x());
    smooth(*rear);
    osg::ref_ptr<osg::Geode> rearGeode = new osg::Geode;
    rearGeode->addDrawable(rear);

    osg::ref_ptr<osg::Group> wings = new osg::Group;
    wings->addChild(geode);
    wings->addChild(rearGeode);
    return wings;
}

osg::ref_ptr<const osg::Node> createParts()
{
    osg::ref_ptr<osg::Group> car = new osg::Group;
    car->setName("racing car");
    car->addChild(createBody());
    car->addChild(createCockpit());
    car->addChild(createWheels());
    car->addChild(createMetalParts());
    car->addChild(createWings());
    return car;
}

/** Copies nodes, drawables and state, each once, so that subgraphs that are shared stay so. */
class CarCopy : public osg::CopyOp
{
public:
    CarCopy() : CopyOp(DEEP_COPY_NODES | DEEP_COPY_DRAWABLES | DEEP_COPY_STATESETS) {}

    osg::Node* operator()(const osg::Node* node) const override
    {
        osg::ref_ptr<osg::Node>& copy = _copies[node];
        if (!copy) copy = CopyOp::operator()(node);
        return copy;
    }

private:
    mutable std::map<const osg::Node*, osg::ref_ptr<osg::Node>> _copies;
};

} // namespace

osg::ref_ptr<osg::Node> createRacingCar()
{
    static const osg::ref_ptr<const osg::Node> CAR = createParts();
    return osg::clone(CAR.get(), CarCopy());
}

} // namespace osgLego
