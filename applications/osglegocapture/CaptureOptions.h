#pragma once

#include "Comparison.h"

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LegoSettings.h>

#include <optional>
#include <string>

namespace osgLego
{

/** Which way of making a GL context is used. */
enum class ContextKind
{
    AUTO, //!< EGL, and OSMesa where there is none
    EGL,
    OSMESA
};

/** Where the camera stands, around the middle of the model. */
struct CaptureView
{
    double azimuth = 30.0;   //!< degrees; 0 looks at the front, 90 at the right side of it
    double elevation = 25.0; //!< degrees above the horizon, -90 to 90
    double distance = 0.0;   //!< radii of the mesh's bounding sphere from its middle; 0: as near as all of it fits in
    bool orthographic = false;
    double near = 0.0; //!< radii before the camera of which nothing is drawn; 0: as it comes
};

/** The light from all around. */
struct CaptureProbe
{
    std::string file;  //!< empty: the built-in sky
    double turn = 0.0; //!< degrees around the axis that is up
    double intensity = 1.0;

    bool operator==(const CaptureProbe&) const = default;
};

/** What the command line of osglegocapture says. */
struct CaptureOptions
{
    std::string mesh;          //!< empty: the built-in model
    std::string readerOptions; //!< for the reader of the mesh, as osgviewer's -O
    std::string output;
    std::optional<LegoSettings> settings; //!< unset: 64, or what the file name of the mesh says
    int width = 1280;
    int height = 720;
    CaptureView view;
    CaptureProbe probe;
    bool hasOcclusion = true;
    bool isOcclusionGiven = false; //!< whether the command line has the option, and not its default
    AmbientOcclusionSettings occlusion;
    bool original = false;
    bool transparent = false; //!< the background
    ContextKind context = ContextKind::AUTO;
    std::string statistics; //!< STANDARD_OUTPUT: to there
    std::string cells;
    std::string reference;
    double threshold = DEFAULT_THRESHOLD; //!< of `reference`

    static constexpr const char* STANDARD_OUTPUT = "-";
};

/** Read the command line; help and mistakes are answered here.
 * @return the exit code when the program is to end now, nothing when it is to go on with `options`. */
std::optional<int> readOptions(int argc, char** argv, CaptureOptions& options);

} // namespace osgLego
