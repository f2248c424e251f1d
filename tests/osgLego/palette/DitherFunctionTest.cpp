#include <osgLego/palette/Dither.h>

#include <GlslFunctionTest.h>

#include <array>
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
    std::vector<float> expected;
    for (int number = 0; number < 4000; ++number)
    {
        std::array<unsigned int, 3> cell;
        for (unsigned int& coordinate : cell)
            coordinate = static_cast<unsigned int>(engine() % 2560);
        arguments.push_back({glm::vec4(cell[0], cell[1], cell[2], 0), glm::vec4(0), glm::vec4(0), glm::vec4(0)});
        expected.push_back(static_cast<float>(Dither::thresholdAt(cell[0], cell[1], cell[2])));
    }
    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    const std::vector<glm::vec4> results =
        evaluate("tests/dither.vert",
                 "#include \"osgLego/palette/Dither.h\"\n"
                 "void main() { result = vec4(float(thresholdAt(uint(a.x), uint(a.y), uint(a.z)))); }\n",
                 arguments, *stateSet);
    for (std::size_t number = 0; number < expected.size(); ++number)
        ASSERT_EQ(results[number].x, expected[number]) << number;
}

} // namespace

} // namespace osgLego::test
