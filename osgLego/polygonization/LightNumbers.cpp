#include <osgLego/polygonization/LightNumbers.h>

#include <cstddef>

namespace osgLego
{

LightNumbers::LightNumbers(const osg::State& state)
{
    for (int light = 0; light < MAXIMUM; ++light)
        if (state.getLastAppliedMode(GL_LIGHT0 + static_cast<unsigned int>(light)))
            numbers[static_cast<std::size_t>(count++)] = light;
    if (!state.getLastAppliedMode(GL_LIGHTING)) count = -1;
}

} // namespace osgLego
