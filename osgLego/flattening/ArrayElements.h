#pragma once

#include <glm/vec4.hpp>
#include <osg/Array>

namespace osgLego
{

/** Whether integers in an array are whole numbers or fractions of their range. */
enum class IntegerMeaning
{
    VALUE,   //!< as positions and texture coordinates are read: 255 is 255
    FRACTION //!< as colours are read: an unsigned byte of 255 is 1, a signed byte of 127 is 1
};

/** Read element `index` of any osg::Array of up to four components a vertex, float, double or integer.
 *
 * Components that the array lacks are 0, the fourth 1, as in GL.
 * @return false, and `element` unchanged, when there is no such element or the array holds something else. */
bool readElement(const osg::Array& array, unsigned int index, IntegerMeaning meaning, glm::dvec4& element);

} // namespace osgLego
