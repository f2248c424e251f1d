#pragma once

#include "Comparison.h"

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/Stability.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** How the GL context is created. */
enum class ContextKind
{
    AUTO, //!< EGL, or OSMesa if EGL is not available
    EGL,
    OSMESA
};

/** The camera, relative to the centre of the model. */
struct CaptureView
{
    double azimuth = 30.0;   //!< degrees; 0: front view, 90: from the right
    double elevation = 25.0; //!< degrees above the horizon, -90 to 90
    double distance = 0.0;   //!< from the centre of the mesh's bounding sphere, in its radii; 0: as near as all fits in
    bool orthographic = false;
    double near = 0.0; //!< distance of the near plane, in the same radii; 0: automatic
};

/** The environment light. */
struct CaptureProbe
{
    std::string file;  //!< empty: the built-in sky
    double turn = 0.0; //!< degrees about the up axis
    double intensity = 1.0;

    bool operator==(const CaptureProbe&) const = default;
};

/** A weight on a part, for the computation of stability. */
struct CaptureLoad
{
    glm::ivec3 cell{0}; //!< a cell of the part, in the grid
    double grams = 0.0;
};

/** The command line of osglegocapture. */
struct CaptureOptions
{
    std::string mesh;          //!< empty: the built-in model
    std::string readerOptions; //!< for the reader of the mesh, like osgviewer's -O
    std::string output;
    std::optional<LegoSettings> settings; //!< unset: 64, or the settings in the mesh's file name
    std::string settingsText;             //!< those given; a model for `build` keeps them
    int width = 1280;
    int height = 720;
    bool isSizeGiven = false; //!< whether the command line has a size, and not its default
    int samples = 4;          //!< per pixel; the command line has no option for it
    CaptureView view;
    bool isViewGiven = false; //!< whether the command line has a view, and not its default
    CaptureProbe probe;
    bool hasOcclusion = false; //!< whether there is an AmbientOcclusionScene
    BrickOcclusion brickOcclusion = BrickOcclusion::GRID;
    bool isOcclusionGiven = false; //!< whether the command line has the option, and not its default
    AmbientOcclusionSettings occlusion;
    bool original = false;
    bool transparent = false; //!< whether the background is transparent
    ContextKind context = ContextKind::AUTO;
    bool bound = false;               //!< whether the statistics have the fewest parts possible
    std::optional<BuildingBase> base; //!< on which the stability of the parts is computed; unset: it is not
    bool tilt = false;                //!< whether the tilt that the parts stand is computed, for `base`
    std::vector<CaptureLoad> loads;   //!< for `base`
    std::string statistics;           //!< STANDARD_OUTPUT: write to standard output
    std::string cells;
    std::string partsList;    //!< .csv or .xml; STANDARD_OUTPUT: write a table to standard output
    std::string instructions; //!< the folder for a booklet; empty: none
    /** The steps in the booklet, from 1 on: the first and the last; unset: all. */
    std::optional<std::pair<std::size_t, std::size_t>> bookletSteps;
    std::string title;                     //!< of the booklet and its model; empty: BookletOptions has the default
    std::string author;                    //!< likewise
    std::string license;                   //!< of the booklet's model in LDraw's format; likewise
    bool isBookletConfirmed = false;       //!< whether a very large booklet is confirmed
    std::string build;                     //!< the folder for a model with all that belongs to it; empty: none
    std::optional<std::size_t> buildParts; //!< the most parts of that model; unset: a length, or the default
    std::optional<double> buildLength;     //!< the longest side of that model in millimetres
    std::string reference;
    double threshold = DEFAULT_THRESHOLD; //!< for comparing with `reference`

    static constexpr const char* STANDARD_OUTPUT = "-";
    static constexpr std::size_t MOST_PARTS_UNASKED = 2000; //!< of a booklet without `isBookletConfirmed`

    /** Whether an output needs a picture or bricks made by GL. */
    bool needsContext() const;
};

/** Read the command line, and print help and error messages.
 * @return the exit code if the program must exit now; nothing if it should continue with `options`. */
std::optional<int> readOptions(int argc, char** argv, CaptureOptions& options);

} // namespace osgLego
