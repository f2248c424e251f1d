#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LegoSettings.h>

#include <string>
#include <vector>

namespace osgLego
{

/** A mesh in bricks, and where it is looked at from. */
struct BenchScene
{
    std::string name;
    std::string mesh; //!< a file; empty: the built-in car; "stair": steps of ten bricks
    LegoSettings settings;
    double azimuth = 30.0; //!< degrees, as osglegocapture's --view
    double elevation = 25.0;
    double distance = 3.5; //!< radii of the bricks' bounding sphere
};

/** How far ambient occlusion in screen space is from rays cast at the bricks themselves. */
struct OcclusionError
{
    std::size_t numPixels = 0;
    double rootMeanSquare = 0.0; //!< of visibility, 0 to 1
    double mean = 0.0;           //!< signed: above 0 is too bright
    double constant = 0.0;       //!< root mean square of the best picture of one grey
    double bentMean = 0.0;       //!< degrees between bent normals
    double bentMost = 0.0;       //!< the same, of 95 % of the pixels
    double irradiance = 0.0;     //!< root mean square of irradiance times visibility, over its mean
};

/** Draw scenes with each quality, cast rays from what their pixels show, and compare.
 *
 * Needs GL by EGL; throws std::runtime_error when there is none or a mesh can't be read. One thread.
 * @param numRays for each pixel that is compared, which is one of `stride` * `stride`. */
OcclusionError measureOcclusion(const BenchScene& scene, AmbientOcclusionQuality quality, int numRays, int stride);

/** The milliseconds of drawing bricks and of each pass behind it, at a size in pixels: medians over frames. */
AmbientOcclusionTimes measureOcclusionTimes(const BenchScene& scene, AmbientOcclusionQuality quality, int width,
                                            int height, int numFrames);

/** The scenes that occlusion is measured on; those with a file that is not there are left out, with a word. */
std::vector<BenchScene> createOcclusionScenes(const std::string& modelFolder);

} // namespace osgLego
