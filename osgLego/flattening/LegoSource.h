#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <cstdint>

#include <osg/Referenced>

namespace osgLego
{

/** All that the passes need to know of what is to be legolized; immutable, so that threads may share it. */
struct LegoSource : public osg::Referenced
{
    std::uint64_t revision = 0; //!< a higher number for each new source of a node
    LegoSettings settings;
    osg::ref_ptr<const GridTriangles> triangles;
    double flattening = 0.0; //!< milliseconds that it took to make `triangles`
    bool timing = false;     //!< wait after each stage, to time it
    bool readBack = false;   //!< bring the covered cells back to the CPU
};

} // namespace osgLego
