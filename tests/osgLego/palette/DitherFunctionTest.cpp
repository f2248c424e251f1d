#include <osgLego/palette/Dither.h>

#include <GlslFunctionTest.h>

#include <random>

namespace osgLego::test
{

namespace
{

class DitherFunction : public GlslFunctionTest
{
};

TEST_F(DitherFunction, IsTheSameInGlsl)
{
    std::mt19937 engine(4);
    std::vector<Arguments> arguments;
    std::vector<Dither::Color> expected;
    for (int number = 0; number < 4000; ++number)
    {
        Dither::Color color;
        Dither::Color nearest;
        std::array<std::uint16_t, 3> cell;
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
            color[channel] = static_cast<std::uint8_t>(engine());
            // So close that the distance limits many of the offsets.
            nearest[channel] = static_cast<std::uint8_t>(engine() % 2 ? color[channel] ^ (engine() & 15u) : engine());
            cell[channel] = static_cast<std::uint16_t>(engine() % 2560);
        }
        const int amplitude = static_cast<int>(engine() % 256);
        arguments.push_back({glm::vec4(color[0], color[1], color[2], 0),
                             glm::vec4(nearest[0], nearest[1], nearest[2], 0), glm::vec4(cell[0], cell[1], cell[2], 0),
                             glm::vec4(static_cast<float>(amplitude))});
        expected.push_back(Dither::dithered(color, nearest, cell, amplitude));
    }
    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    const std::vector<glm::vec4> results =
        evaluate("tests/dither.vert",
                 "#include \"osgLego/palette/Dither.h\"\n"
                 "void main() { result = vec4(dithered(ivec3(a.rgb), ivec3(b.rgb), uvec3(c.xyz), int(d.x)), 0.0); }\n",
                 arguments, *stateSet);
    for (std::size_t number = 0; number < expected.size(); ++number)
        for (std::size_t channel = 0; channel < 3; ++channel)
            ASSERT_EQ(results[number][static_cast<int>(channel)], expected[number][channel]) << number;
}

} // namespace

} // namespace osgLego::test
