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
    /** The view for a traversal of the scene; created if there is none with the right format.
     * @return null if the scene must be drawn like an osg::Group: inside another AmbientOcclusionScene, by a camera
     * that draws only depth, or, with one warning, in a context that lacks features or memory. */
    osg::ref_ptr<AmbientOcclusionView> find(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings,
                                            const LightProbe& probe);

    /** Discard all views, so that new ones are created. */
    void clear();

    AmbientOcclusionTimes getTimes(unsigned int contextID) const;

    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    const AmbientOcclusionPrograms& getPrograms(const OcclusionFormat& format, const LightProbe& probe);
    void warn(unsigned int contextID, const std::string& why);

    mutable std::mutex _mutex;
    PerVisit<osg::ref_ptr<AmbientOcclusionView>> _views;
    using Variant = std::pair<int, AmbientOcclusionQuality>;
    std::map<Variant, osg::ref_ptr<const AmbientOcclusionPrograms>> _programs;
    std::vector<unsigned int> _warned; // IDs of contexts with a warning
};

} // namespace osgLego
