#pragma once

#include "Contender.h"
#include "GpuStopwatch.h"
#include "StageTimes.h"

#include <osgLego/LegoNode.h>

#include <string>

#include <osg/FrameStamp>
#include <osgUtil/SceneView>

namespace osgLego
{

/** This project's own methods, as a program has them: a LegoNode in a scene, legolized anew in each run.
 *
 * Its time is that of the stages from triangles in the grid to points of bricks, each waited for; neither flattening,
 * which nobody else does, nor the frame around it. The bricks are not drawn.
 */
class LegoNodeContender : public Contender, public StageTimes
{
public:
    /** @param settings what the text form of LegoSettings says of the method; the rest comes with the mesh. */
    LegoNodeContender(std::string name, std::string settings);

    std::string getName() const override { return _name; }
    bool hasColors() const override { return true; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() override;
    osg::ref_ptr<const BrickModel> getBricks() override;
    void release() override;
    std::vector<std::pair<std::string, double>> getStageTimes() const override;

private:
    void createView();
    std::string drawFrame();

    std::string _name;
    std::string _settings;
    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<osg::FrameStamp> _frameStamp;
    osg::ref_ptr<osgUtil::SceneView> _view;
    GpuStopwatch _stopwatch;
};

} // namespace osgLego
