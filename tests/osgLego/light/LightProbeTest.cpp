#include "ProbeChecks.h"

#include <Notices.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using namespace test;

constexpr double PI = std::numbers::pi;

TEST(LightProbe, ConstantLightMakesConstantIrradiance)
{
    for (const auto& probe : createProbes(constant(1.0)))
    {
        for (const osg::Vec3d& normal : createNormals())
        {
            expectNear(probe->getIrradiance(normal), grey(1.0), 1e-3);
            expectNear(probe->getHarmonicIrradiance(normal), grey(1.0), 1e-3);
        }
        EXPECT_LT(probe->getHarmonicError(), 1e-3);
        EXPECT_FALSE(probe->usesConvolvedMap());
    }
}

TEST(LightProbe, SolidAnglesMakeASphere)
{
    for (const auto& probe : createProbes(constant(1.0)))
    {
        // The first harmonic is 1 / sqrt(4 pi) everywhere: its coefficient is that times the sum of the solid angles.
        EXPECT_NEAR(probe->getCoefficients()[0].x() * std::sqrt(4.0 * PI), 4.0 * PI, 1e-3);
        for (std::size_t index = 1; index < 9; ++index)
            EXPECT_NEAR(probe->getCoefficients()[index].x(), 0.0, 1e-3) << index;
    }
}

TEST(LightProbe, AGradientKeepsTwoThirds)
{
    for (const auto& probe : createProbes([](const osg::Vec3d& d) { return grey(1.0 + d.z()); }))
        for (const osg::Vec3d& normal : createNormals())
            expectNear(probe->getIrradiance(normal), grey(1.0 + 2.0 / 3.0 * normal.z()), 2e-3);
}

TEST(LightProbe, ACosineLobeMatchesItsClosedForm)
{
    for (const auto& probe : createProbes([](const osg::Vec3d& d) { return grey(std::max(d.z(), 0.0)); }))
    {
        EXPECT_NEAR(probe->getIrradiance({0.0, 0.0, 1.0}).x(), 2.0 / 3.0, 0.01);
        EXPECT_NEAR(probe->getIrradiance({1.0, 0.0, 0.0}).x(), 2.0 / (3.0 * PI), 0.01);
        EXPECT_NEAR(probe->getIrradiance({0.0, 0.0, -1.0}).x(), 0.0, 0.01);
    }
}

TEST(LightProbe, HarmonicsEqualTheSumOverAllPixels)
{
    const auto smooth = [](const osg::Vec3d& d)
    {
        return osg::Vec3d(1.0 + 0.6 * d.x() * d.y() - 0.3 * d.z(), 0.7 + d.z() * d.z() + 0.5 * d.x() * d.z(),
                          0.8 + 0.5 * d.y() + 0.2 * d.x() * d.x() * d.y());
    };
    const std::vector<osg::Vec3d> normals = createNormals();
    const std::vector<osg::Vec3d> sums = sumIrradiance(*createLatitudeLongitude(256, smooth), normals);
    for (const auto& probe : createProbes(smooth))
    {
        EXPECT_FALSE(probe->usesConvolvedMap());
        for (std::size_t index = 0; index < normals.size(); ++index)
            expectNear(probe->getHarmonicIrradiance(normals[index]), sums[index], 0.005);
    }
}

TEST(LightProbe, ASmallLampIsConvolved)
{
    osg::Vec3d lampDirection(0.5, 0.3, 0.6);
    lampDirection.normalize();
    // A radius of five degrees.
    const auto lamp = [&](const osg::Vec3d& d)
    { return d * lampDirection > 0.9962 ? osg::Vec3d(400.0, 300.0, 200.0) : grey(0.05); };
    const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(512, lamp);
    const osg::ref_ptr<LightProbe> probe = createProbe(image);
    EXPECT_GT(probe->getHarmonicError(), 0.1);
    ASSERT_TRUE(probe->usesConvolvedMap());

    std::vector<osg::Vec3d> normals = createNormals();
    normals.push_back(lampDirection);
    const std::vector<osg::Vec3d> sums = sumIrradiance(*image, normals);
    const double brightest = sums.back().x();
    double squares = 0.0;
    for (std::size_t index = 0; index < normals.size(); ++index)
    {
        const osg::Vec3d& normal = normals[index];
        const osg::Vec3d irradiance = probe->getIrradiance(normal);
        const double difference = irradiance.x() - sums[index].x();
        EXPECT_GE(std::min({irradiance.x(), irradiance.y(), irradiance.z()}), 0.0);
        EXPECT_GE(probe->getHarmonicIrradiance(normal).x(), 0.0);
        // Linear interpolation between two pixels is off at the lamp's horizon, where irradiance has a kink.
        EXPECT_NEAR(difference, 0.0, (std::abs(normal * lampDirection) < 0.1 ? 0.03 : 0.01) * brightest);
        squares += difference * difference;
    }
    const double mean = meanOf(*probe->getConvolvedMap()).x();
    EXPECT_LT(std::sqrt(squares / static_cast<double>(normals.size())), 0.01 * mean);
}

TEST(LightProbe, ConvolvedPixelsAreSumsOverAllPixels)
{
    const auto lamp = [](const osg::Vec3d& d) { return d.x() > 0.99 ? grey(100.0) : grey(0.1 + 0.05 * d.y()); };
    const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(256, lamp);
    const osg::ref_ptr<LightProbe> probe = createProbe(image);
    const osg::Image& map = *probe->getConvolvedMap();
    ASSERT_EQ(map.s(), LightProbe::CONVOLVED_WIDTH);
    ASSERT_EQ(map.t(), LightProbe::CONVOLVED_WIDTH / 2);
    ASSERT_EQ(map.getPixelFormat(), GLenum(GL_RGB));
    ASSERT_EQ(map.getDataType(), GLenum(GL_FLOAT));
    const double mean = meanOf(map).x();
    std::vector<osg::Vec3d> normals;
    for (int index = 0; index < map.s() * map.t(); ++index)
        normals.push_back(latitudeLongitudeDirection(index % map.s(), index / map.s(), map.s(), map.t()));
    const std::vector<osg::Vec3d> sums = sumIrradiance(*image, normals);
    for (std::size_t index = 0; index < normals.size(); ++index)
    {
        const int pixel = static_cast<int>(index);
        EXPECT_NEAR(pixelOf(map, pixel % map.s(), pixel / map.s()).x(), sums[index].x(), 0.01 * mean);
    }
}

TEST(LightProbe, RotationAndIntensityAct)
{
    const osg::ref_ptr<LightProbe> probe =
        createProbe(createLatitudeLongitude(128, [](const osg::Vec3d& d) { return grey(1.0 + d.y()); }));
    // A quarter turn to the left moves light from ahead (+Y) to -X.
    probe->setRotation(osg::Quat(0.5 * PI, osg::Vec3d(0.0, 0.0, 1.0)));
    probe->setIntensity(3.0);
    expectNear(probe->getIrradiance({-1.0, 0.0, 0.0}), grey(5.0), 0.01);
    expectNear(probe->getIrradiance({7.0, 0.0, 0.0}), grey(1.0), 0.01);
    expectNear(probe->getIrradiance({0.0, 1.0, 0.0}), grey(3.0), 0.01);
    expectNear(probe->getHarmonicIrradiance({0.0, 1.0, 0.0}), grey(5.0 / 3.0), 0.01);
    EXPECT_EQ(probe->getIrradiance(osg::Vec3d()), osg::Vec3d());

    probe->setIntensity(0.0);
    EXPECT_EQ(probe->getIrradiance({0.0, 0.0, 1.0}), osg::Vec3d());
}

TEST(LightProbe, RefusesInvalidIntensitiesAndRotations)
{
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    probe->setIntensity(2.0);
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, notANumber, std::numeric_limits<double>::infinity()})
        EXPECT_NE(noticesOf([&] { probe->setIntensity(bad); }).find("expected 0 or more"), std::string::npos);
    EXPECT_EQ(probe->getIntensity(), 2.0);
    for (const double bad : {0.0, notANumber})
        EXPECT_NE(noticesOf([&] { probe->setRotation(osg::Quat(bad, bad, bad, bad)); }).find("expected"),
                  std::string::npos);
    EXPECT_EQ(probe->getRotation(), osg::Quat());
    probe->setRotation(osg::Quat(0.0, 0.0, 0.0, 5.0));
    EXPECT_EQ(probe->getRotation(), osg::Quat());
}

TEST(LightProbe, TheFirstReflectionIsThePicture)
{
    const auto pattern = [](const osg::Vec3d& d)
    { return osg::Vec3d(1.0 + std::sin(9.0 * d.x()), 1.0 + std::cos(7.0 * d.y()), 1.0 + d.z()); };
    for (const int width : {256, 512, 64})
    {
        const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(width, pattern);
        const osg::ref_ptr<LightProbe> probe = createProbe(image);
        const osg::Image& map = *probe->getReflectionMap(0);
        ASSERT_EQ(map.s(), 256);
        ASSERT_EQ(map.t(), 128);
        // Except at the poles, where the mean over a pixel differs from the value at its centre.
        for (int row = 8; row < 120; row += 9)
            for (int column = 3; column < 256; column += 7)
                expectNear(pixelOf(map, column, row), pattern(latitudeLongitudeDirection(column, row, 256, 128)),
                           width < 256 ? 0.5 : 0.005);
    }
    const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(256, pattern);
    const osg::ref_ptr<LightProbe> probe = createProbe(image);
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column)
            expectNear(pixelOf(*probe->getReflectionMap(0), column, row), pixelOf(*image, column, row), 1e-5);
}

TEST(LightProbe, EverySurfaceReflectsConstantLightUnchanged)
{
    const osg::ref_ptr<LightProbe> probe = createProbe(createLatitudeLongitude(64, constant(3.0)));
    for (int level = 0; level < LightProbe::REFLECTION_LEVELS; ++level)
    {
        const osg::Image& map = *probe->getReflectionMap(level);
        ASSERT_EQ(map.s(), 256 >> level);
        ASSERT_EQ(map.t(), 128 >> level);
        for (int row = 0; row < map.t(); ++row)
            for (int column = 0; column < map.s(); ++column)
                expectNear(pixelOf(map, column, row), grey(3.0), 1e-3);
    }
    EXPECT_EQ(probe->getReflectionMap(-1), nullptr);
    EXPECT_EQ(probe->getReflectionMap(LightProbe::REFLECTION_LEVELS), nullptr);
}

TEST(LightProbe, RoughSurfacesBlurLightButKeepItsAmount)
{
    osg::Vec3d lampDirection(0.6, -0.5, 0.4);
    lampDirection.normalize();
    const auto lamp = [&](const osg::Vec3d& d)
    { return grey(0.2 + 10.0 * std::exp(30.0 * (d * lampDirection - 1.0))); };
    const osg::ref_ptr<LightProbe> probe = createProbe(createLatitudeLongitude(256, lamp));
    const double mean = meanOf(*probe->getReflectionMap(0)).x();
    double brightestBefore = 11.0;
    for (int level = 0; level < LightProbe::REFLECTION_LEVELS; ++level)
    {
        const osg::Image& map = *probe->getReflectionMap(level);
        double brightest = 0.0;
        osg::Vec3d where;
        for (int row = 0; row < map.t(); ++row)
            for (int column = 0; column < map.s(); ++column)
                if (pixelOf(map, column, row).x() > brightest)
                {
                    brightest = pixelOf(map, column, row).x();
                    where = latitudeLongitudeDirection(column, row, map.s(), map.t());
                }
        EXPECT_NEAR(meanOf(map).x(), mean, (level < 4 ? 0.01 : 0.05) * mean) << level;
        EXPECT_LT(brightest, brightestBefore) << level;
        EXPECT_GT(where * lampDirection, std::cos(1.5 * PI / map.t())) << level;
        brightestBefore = brightest;
    }
}

TEST(LightProbe, ReflectionFollowsTheDistribution)
{
    // The reflection of a one-pixel lamp is the lobe itself: the half vector is halfway to the lamp.
    const osg::ref_ptr<osg::Image> image = createEmptyImage(128, 64);
    reinterpret_cast<osg::Vec3f*>(image->data(64, 32))->set(1000.0f, 1000.0f, 1000.0f);
    const osg::ref_ptr<LightProbe> probe = createProbe(image);
    const osg::Image& map = *probe->getReflectionMap(1);
    const double alphaSquared = std::pow(0.2, 4.0);
    const auto lobeAt = [&](int columns)
    {
        const osg::Vec3d lamp = latitudeLongitudeDirection(64, 32, 128, 64);
        const double cosine = lamp * latitudeLongitudeDirection(64 + columns, 32, 128, 64);
        const double denominator = 0.5 * (1.0 + cosine) * (alphaSquared - 1.0) + 1.0;
        return cosine / (denominator * denominator);
    };
    for (const int columns : {1, 2, 4, 8})
        EXPECT_NEAR(pixelOf(map, 64 + columns, 32).x() / pixelOf(map, 64, 32).x(), lobeAt(columns) / lobeAt(0), 1e-3);
}

TEST(LightProbe, TheSkyIsBrightAboveAndLightsNoTwoSidesAlike)
{
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    const osg::Vec3d up = probe->getIrradiance({0.0, 0.0, 1.0});
    const osg::Vec3d front = probe->getIrradiance({0.0, -1.0, 0.0});
    const osg::Vec3d right = probe->getIrradiance({1.0, 0.0, 0.0});
    const osg::Vec3d left = probe->getIrradiance({-1.0, 0.0, 0.0});
    const osg::Vec3d back = probe->getIrradiance({0.0, 1.0, 0.0});
    const osg::Vec3d down = probe->getIrradiance({0.0, 0.0, -1.0});
    expectNear(up, grey(1.16), 0.06, "up");
    expectNear(front, grey(0.59), 0.06, "front");
    expectNear(down, grey(0.09), 0.03, "down");
    EXPECT_GT(front.y(), 1.3 * right.y());
    EXPECT_GT(right.y(), 1.3 * back.y());
    EXPECT_GT(front.y(), 1.3 * left.y());
    EXPECT_GT(left.y(), 1.05 * back.y());
    EXPECT_GT(front.x(), front.z()) << "the glow is warm";
    EXPECT_GT(back.z(), back.x()) << "the sky is blue";

    double brightest = 0.0;
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column)
            brightest = std::max(brightest, pixelOf(*probe->getReflectionMap(0), column, row).y());
    EXPECT_GT(brightest, 3.0 * up.y());
}

TEST(LightProbe, TheSkyIsMadeOnceForAllThreads)
{
    const osg::ref_ptr<LightProbe> probes[]{new LightProbe, new LightProbe};
    std::vector<osg::Image*> maps(4);
    std::vector<std::thread> threads;
    for (std::size_t index = 0; index < maps.size(); ++index)
        threads.emplace_back([&, index] { maps[index] = probes[index % 2]->getConvolvedMap(); });
    for (std::thread& thread : threads)
        thread.join();
    for (osg::Image* map : maps)
        EXPECT_EQ(map, maps.front());
}

TEST(LightProbe, ANullImageRestoresTheSky)
{
    const osg::ref_ptr<LightProbe> probe = createProbe(createLatitudeLongitude(8, constant(1.0)));
    std::string error;
    EXPECT_TRUE(probe->setImage(nullptr, LightProbe::AUTO, error));
    EXPECT_EQ(probe->getImage(), nullptr);
    const osg::ref_ptr<LightProbe> sky = new LightProbe;
    EXPECT_EQ(probe->getConvolvedMap(), sky->getConvolvedMap());
}

TEST(LightProbe, AFailureChangesNothing)
{
    const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(8, constant(1.0));
    const osg::ref_ptr<LightProbe> probe = createProbe(image);
    osg::Image* map = probe->getConvolvedMap();
    std::string error;
    EXPECT_FALSE(probe->setImage(createEmptyImage(9, 3), LightProbe::AUTO, error));
    EXPECT_EQ(probe->getImage(), image);
    EXPECT_EQ(probe->getConvolvedMap(), map);
}

TEST(LightProbe, CopiesShareTheFilteredLight)
{
    const osg::ref_ptr<LightProbe> probe = createProbe(createLatitudeLongitude(8, constant(1.0)));
    probe->setIntensity(2.0);
    probe->setRotation(osg::Quat(0.5, osg::Vec3d(1.0, 0.0, 0.0)));
    probe->setName("park");
    const osg::ref_ptr<LightProbe> shallow = osg::clone(probe.get(), osg::CopyOp::SHALLOW_COPY);
    const osg::ref_ptr<LightProbe> deep = osg::clone(probe.get(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(shallow->getImage(), probe->getImage());
    EXPECT_NE(deep->getImage(), probe->getImage());
    for (const auto& copy : {shallow, deep})
    {
        EXPECT_EQ(copy->getConvolvedMap(), probe->getConvolvedMap());
        EXPECT_EQ(copy->getIntensity(), 2.0);
        EXPECT_EQ(copy->getRotation(), probe->getRotation());
        EXPECT_EQ(copy->getName(), "park");
    }
    std::string error;
    EXPECT_TRUE(shallow->setImage(nullptr, LightProbe::AUTO, error));
    EXPECT_NE(shallow->getConvolvedMap(), probe->getConvolvedMap());
}

} // namespace

} // namespace osgLego
