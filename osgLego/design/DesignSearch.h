#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/ModelDesigner.h>
#include <osgLego/design/DesignRanking.h>
#include <osgLego/design/SurfaceReference.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The search of designModel(): makes models by several settings, compares them, and supports the best if they fall.
 *
 * One run per object, in one thread, which uses all threads that oneTBB gives it. */
class DesignSearch
{
public:
    /** Thrown by run(), with a sentence for the user; an empty one if it was cancelled. */
    struct Failure : std::exception
    {
        explicit Failure(std::string message) : error(std::move(message)) {}
        const char* what() const noexcept override { return error.c_str(); }

        std::string error;
    };

    /** @param node and @param options are kept as references. */
    DesignSearch(const osg::Node& node, const DesignOptions& options);

    /** Throws Failure. */
    ModelDesign run();

private:
    struct Laid
    {
        LegoSettings settings;
        osg::ref_ptr<const BrickModel> model;
        LayoutStatistics layout;
    };

    void checkParts() const;
    bool determineSize() const;
    bool isConnectionGiven() const;
    /** Whether the number of parts limits the size, rather than the options giving it. */
    bool canChooseSize() const { return !_isSizeGiven && !_options.length; }
    std::size_t getMostParts() const;
    DesignRanking createRanking() const;
    std::vector<LegoSettings> listSettings() const;
    void readSurface(UpAxis upAxis);
    Laid lay(const LegoSettings& settings) const;
    Laid layJoined(const LegoSettings& settings) const;
    std::size_t countDraftParts(const LegoSettings& settings) const;
    unsigned int findResolution(LegoSettings settings) const;
    DesignCandidate makeLargest(LegoSettings settings) const;
    DesignCandidate makeSupported(LegoSettings settings) const;
    DesignCandidate measure(const Laid& laid) const;
    void setDifference(const BrickModel& model, DesignCandidate& candidate) const;
    double measureDraft(LegoSettings settings, unsigned int resolution) const;
    void makeCandidates(const std::vector<LegoSettings>& settings);
    void addCandidate(DesignCandidate candidate);
    void tryLowerResolutions();
    void supportBetter();
    void planBest();
    void planBuildingOf(DesignCandidate& candidate) const;
    void checkCancelled() const;
    void report(double share);

    const osg::Node& _node;
    const DesignOptions& _options;
    osg::ref_ptr<const SceneTriangles> _triangles;
    std::unique_ptr<SurfaceReference> _surface;
    double _longestSide = 1.0; // of the mesh, in model units
    std::vector<DesignCandidate> _candidates;
    bool _isSizeGiven = false;       // by the settings of the options
    bool _isConnectionGiven = false; // by them, too
    std::mutex _reporting;           // guards _progress
    double _progress = 0.0;
};

} // namespace osgLego
