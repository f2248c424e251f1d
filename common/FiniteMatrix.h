#pragma once

#include <algorithm>
#include <cmath>

#include <osg/Matrixd>

namespace osgLego
{

/** Whether all elements of a matrix are finite; osg::Matrixd::valid() accepts infinity. */
inline bool isFinite(const osg::Matrixd& matrix)
{
    return std::all_of(matrix.ptr(), matrix.ptr() + 16, [](double element) { return std::isfinite(element); });
}

} // namespace osgLego
