#pragma once

#include <osgLego/LegoProgress.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/ModelDesigner.h>
#include <osgLego/design/SurfaceReference.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <functional>
#include <memory>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Makes models of a mesh, measures them, and plans how they are built.
 *
 * Several threads may call it at once. All functions throw DesignFailure. */
class DesignMaker
{
public:
    struct Laid
    {
        LegoSettings settings;
        osg::ref_ptr<const BrickModel> model;
        LayoutStatistics layout;
    };
    /** @param node is not kept. @param options are kept as a reference. @param upAxis of all models. */
    DesignMaker(const osg::Node& node, const DesignOptions& options, UpAxis upAxis);

    /** @param progress is called with the stages of the work, in the caller's thread; may be empty. */
    Laid lay(const LegoSettings& settings, const std::function<void(const LegoProgress&)>& progress = nullptr) const;
    /** A model whose parts are laid fast and not joined, which looks like the final one. */
    osg::ref_ptr<const BrickModel> layDraft(const LegoSettings& settings) const;
    /** DesignCandidate::getError() of a model; the largest number if it has no bricks, since its grid misses the mesh.
     */
    double computeError(const BrickModel& model) const;
    DesignCandidate measure(const Laid& laid) const;
    void planBuildingOf(DesignCandidate& candidate) const;

private:
    void checkCancelled() const;
    void setDifference(const BrickModel& model, DesignCandidate& candidate) const;

    const DesignOptions& _options;
    osg::ref_ptr<const SceneTriangles> _triangles;
    std::unique_ptr<SurfaceReference> _surface;
    double _longestSide = 1.0; // of the mesh, in model units
};

} // namespace osgLego
