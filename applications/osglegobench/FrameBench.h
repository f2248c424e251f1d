#pragma once

#include "BenchMeshes.h"
#include "OcclusionBench.h"
#include "Spread.h"

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** How the bricks of a frame are drawn. */
enum class FrameLook
{
    PLAIN,
    FULL,
    OCCLUSION, //!< the full look under an AmbientOcclusionScene
    BUFFER     //!< of that only the bricks, without the passes behind them
};

/** How far two pictures are apart. */
struct FrameDifference
{
    int largest = 0;             //!< of 255
    double rootMeanSquare = 0.0; //!< of 255
    std::size_t numPixels = 0;   //!< that differ by more than 2 of 255
    std::size_t numDrawn = 0;    //!< that are not the background

    /** Whether nobody would see a difference: less than a grey level in a hundredth of what is drawn. */
    bool isSame() const;
};

/** Bricks drawn as they are now, beside the reference: every face and every stud drawn, of 16 sides. */
struct FrameComparison
{
    Spread reference; //!< milliseconds
    Spread present;
    FrameDifference difference;

    /** How many times as fast as the reference. */
    double getRatio() const { return reference.median / present.median; }
};

struct FrameResults;

/** What to measure by measureFrames(). */
struct FrameOptions
{
    MeshSource mesh;
    std::vector<unsigned int> resolutions;
    unsigned int numFrames = 5;
    glm::ivec2 size{1280, 720};
    std::string pictureFolder; //!< for pictures of all that is compared; empty: none
};

/** Draw frames of a scene in both ways in turn, in one context, and compare their pictures.
 *
 * Needs GL by EGL; throws std::runtime_error when there is none or a mesh can't be read. One thread.
 * @param pictureName names two pictures that are written, "-reference.png" and "-present.png" being added; empty: none
 */
FrameComparison compareFrames(const BenchScene& scene, FrameLook look, unsigned int numFrames, const glm::ivec2& size,
                              const std::string& pictureName);

/** Compare frames of a mesh at several resolutions from several places, and count in frames in which nothing changes.
 * Throws as compareFrames() does. */
FrameResults measureFrames(const FrameOptions& options);

} // namespace osgLego
