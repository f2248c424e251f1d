#include <osgLego/flattening/ArrayElements.h>

#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

namespace osgLego
{

namespace
{

template <typename Component>
void readComponents(const char* data, int count, IntegerMeaning meaning, glm::dvec4& element)
{
    double scale = 1.0;
    if constexpr (std::is_integral_v<Component>)
        if (meaning == IntegerMeaning::FRACTION) scale = 1.0 / std::numeric_limits<Component>::max();

    element = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    for (int component = 0; component < count; ++component)
    {
        Component value;
        std::memcpy(&value, data + static_cast<std::size_t>(component) * sizeof(Component), sizeof(Component));
        element[component] = scale * static_cast<double>(value);
    }
}

} // namespace

bool readElement(const osg::Array& array, unsigned int index, IntegerMeaning meaning, glm::dvec4& element)
{
    const int count = array.getDataSize();
    if (index >= array.getNumElements() || count < 1 || count > 4) return false;

    const char* data =
        static_cast<const char*>(array.getDataPointer()) + static_cast<std::size_t>(index) * array.getElementSize();
    switch (array.getDataType())
    {
    case GL_FLOAT:
        readComponents<float>(data, count, meaning, element);
        return true;
    case GL_DOUBLE:
        readComponents<double>(data, count, meaning, element);
        return true;
    case GL_BYTE:
        readComponents<signed char>(data, count, meaning, element);
        return true;
    case GL_UNSIGNED_BYTE:
        readComponents<unsigned char>(data, count, meaning, element);
        return true;
    case GL_SHORT:
        readComponents<short>(data, count, meaning, element);
        return true;
    case GL_UNSIGNED_SHORT:
        readComponents<unsigned short>(data, count, meaning, element);
        return true;
    case GL_INT:
        readComponents<int>(data, count, meaning, element);
        return true;
    case GL_UNSIGNED_INT:
        readComponents<unsigned int>(data, count, meaning, element);
        return true;
    default:
        return false;
    }
}

} // namespace osgLego
