#pragma once

#include "OcclusionBench.h"
#include "Spread.h"

#include <cstddef>
#include <string>
#include <vector>

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
};

/** Draw frames of a scene in both ways in turn, in one context, and compare their pictures.
 *
 * Needs GL by EGL; throws std::runtime_error when there is none or a mesh can't be read. One thread.
 * @param pictureName names two pictures that are written, "-reference.png" and "-present.png" being added; empty: none
 */
FrameComparison compareFrames(const BenchScene& scene, FrameLook look, int numFrames, const std::string& pictureName);

/** Compare frames of a mesh at several resolutions from several places, and print a table.
 * @param pictureFolder for pictures of all of them; empty: none */
void printFrames(const std::string& modelFolder, int numFrames, const std::string& pictureFolder);

} // namespace osgLego
