#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/flattening/SourcePalette.h>
#include <osgLego/palette/PaletteLookup.h>

#include <cstdint>
#include <string>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** A source to be legolized, with its settings; immutable, so that threads may share it. */
struct LegoSource : public osg::Referenced
{
    std::uint64_t revision = 0; //!< above 1; higher by 2 or more for each new source of a node
    LegoSettings settings;
    osg::ref_ptr<const GridTriangles> triangles;
    PaletteLookup lookup;    //!< the colours that bricks may have
    double flattening = 0.0; //!< the time taken to make `triangles`, in milliseconds
    bool timing = false;     //!< wait for each stage to finish, to time it
    bool readBack = false;   //!< read the covered cells back to the CPU

    /** The revision of a draft of the bricks, which are shown until those of the source are ready. */
    std::uint64_t getDraftRevision() const { return revision - 1; }

    /** Create a source of triangles, without a revision.
     * @return null, with one sentence in `error`, if the palette of the settings can't be read. */
    static osg::ref_ptr<LegoSource> create(const SceneTriangles& scene, const LegoSettings& settings,
                                           std::string& error);
    /** The same, with triangles in the grid of the settings and a palette that has been read. */
    static osg::ref_ptr<LegoSource> create(const GridTriangles& triangles, const LegoSettings& settings,
                                           const SettingsPalette& palette, std::string& error);
};

} // namespace osgLego
