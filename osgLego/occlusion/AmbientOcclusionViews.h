#pragma once

#include <osgLego/gl/PerVisit.h>
#include <osgLego/occlusion/AmbientOcclusionView.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** The views of an AmbientOcclusionScene.
 *
 * Every function may be called from any thread.
 */
class AmbientOcclusionViews
{
public:
    /** The view for a visit of the scene; made when there is none that fits.
     * @return null when the scene is to be drawn as a plain group: below another such scene, for a camera that draws
     * depths alone, and in a context that lacks what it takes, or memory, of which a warning tells once. */
    osg::ref_ptr<AmbientOcclusionView> find(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings,
                                            const LightProbe& probe);

    /** Have all views made anew. */
    void clear();

    AmbientOcclusionTimes getTimes(unsigned int contextID) const;

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    const AmbientOcclusionPrograms& getPrograms(const AmbientOcclusionView::Format& format, const LightProbe& probe);
    void warn(unsigned int contextID, const std::string& why);

    mutable std::mutex _mutex;
    PerVisit<osg::ref_ptr<AmbientOcclusionView>> _views;
    std::map<std::pair<int, AmbientOcclusionQuality>, osg::ref_ptr<const AmbientOcclusionPrograms>> _programs;
    std::vector<unsigned int> _warned; // of contexts that lack something
};

} // namespace osgLego
