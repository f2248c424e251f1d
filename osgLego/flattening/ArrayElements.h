#pragma once

#include <glm/vec4.hpp>
#include <osg/Array>

namespace osgLego
{

/** Whether integers in an array are plain numbers or fractions of their range. */
enum class IntegerMeaning
{
    VALUE,   //!< plain numbers, for positions and texture coordinates: 255 is 255
    FRACTION //!< fractions, for colours: an unsigned byte of 255 is 1, a signed byte of 127 is 1
};

/** Read element `index` of any osg::Array with one to four components per vertex, of type float, double or integer.
 *
 * Components that the array lacks are 0, or 1 for the fourth, as in GL.
 * @return false, with `element` unchanged, if there is no such element or the array holds another type. */
bool readElement(const osg::Array& array, unsigned int index, IntegerMeaning meaning, glm::dvec4& element);

} // namespace osgLego
