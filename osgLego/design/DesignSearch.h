#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/ModelDesigner.h>
#include <osgLego/design/DesignMaker.h>
#include <osgLego/design/DesignRanking.h>
#include <osgLego/design/DesignSettings.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The search of designModel(): makes drafts by several settings and models by the better ones, compares them, and
 * supports the best if they fall, or if none is easy to build.
 *
 * One run per object, in one thread, which uses all threads that oneTBB gives it. */
class DesignSearch
{
public:
    /** Throws DesignFailure. @param node is not kept. @param options are kept as a reference. */
    DesignSearch(const osg::Node& node, const DesignOptions& options);

    /** Throws DesignFailure. */
    ModelDesign run();

private:
    using Laid = DesignMaker::Laid;
    /** A model whose parts are laid fast and not joined, which looks like the final one. */
    struct Draft
    {
        LegoSettings settings; // of the final model
        osg::ref_ptr<const BrickModel> model;
        osg::ref_ptr<const BrickModel> larger; // of the next resolution; null if the size is given
        double error = 0.0;                    // the smaller one of the models
    };

    std::optional<std::size_t> getMostParts() const;
    DesignRanking createRanking() const;
    Laid layJoined(const LegoSettings& settings) const;
    Draft makeDraft(LegoSettings settings) const;
    DesignCandidate makeLargest(LegoSettings settings) const;
    DesignCandidate makeSupported(LegoSettings settings, double share);
    std::vector<Draft> makeDrafts(const std::vector<LegoSettings>& settings);
    void makeBetter(const std::vector<Draft>& drafts);
    bool makeOthers(double share, double mostError);
    void makeCandidates(const std::vector<LegoSettings>& settings, double share);
    void addCandidate(DesignCandidate candidate);
    void tryLowerResolutions();
    void supportBetter();
    void planBest();
    void planBetter(double share);
    void supportHard(double share);
    void supportCandidate(std::size_t index, double share);
    void report(double share);

    const DesignOptions& _options;
    const DesignSettings _settings;
    const DesignMaker _maker;
    std::vector<DesignCandidate> _candidates;
    std::vector<Draft> _others;           // clearly less like the mesh
    std::vector<LegoSettings> _supported; // of the models that were made again with support
    std::mutex _reporting;                // guards _progress
    double _progress = 0.0;
};

} // namespace osgLego
