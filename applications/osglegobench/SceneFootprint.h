#pragma once

#include "BenchMeshes.h"
#include "GlLedger.h"

#include <optional>
#include <string>

namespace osgLego
{

/** The memory of a whole process that reads a mesh, makes bricks of it and draws a frame of them. Sizes in MiB. */
struct SceneFootprint
{
    double resident = 0.0;          //!< the most that was resident: what a renderer in software keeps is in it
    double gl = 0.0;                //!< the most that GL's buffers and pictures were together
    double largestGl = 0.0;         //!< the largest of these
    std::string largestGlObject;    //!< what that is
    double largestBlock = 0.0;      //!< of main memory, by operator new
    std::size_t numDrawnBricks = 0; //!< 0: none were made
    bool isSoftware = false;        //!< the renderer has no memory of its own

    /** What both sides take together. */
    double getSum() const { return isSoftware ? resident : resident + gl; }

    /** Measure in this process, in which nothing else should have been done before: a frame of 1280 x 720 with
     * everything on, of bricks found by `device` (auto, gpu, cpu). Throws std::runtime_error. */
    static SceneFootprint measure(const MeshSource& source, unsigned int resolution, const std::string& device);
    /** The same in a process of its own; nothing when that fails, which it says itself why. */
    static std::optional<SceneFootprint> measureApart(const MeshSource& source, unsigned int resolution,
                                                      const std::string& device);

    std::string toText() const;
    /** Nothing when it is not what toText() gives. */
    static std::optional<SceneFootprint> fromText(const std::string& text);
};

} // namespace osgLego
