#pragma once

#include "Contender.h"
#include "baselines/GlRestoration.h"

#include <osgLego/LegoNode.h>

#include <array>
#include <string>

#include <osg/FrameStamp>
#include <osgUtil/SceneView>

namespace osgLego
{

/** A method of this library as applications use it: a LegoNode in a scene, legolized again in each run.
 *
 * Its time is the sum of the stages from triangles in the grid to points of bricks, waiting for the end of each. It
 * does not include flattening, which no other contender does, nor the rest of the frame. The bricks are not drawn.
 */
class LegoNodeContender : public Contender
{
public:
    /** @param settings the method as a text of LegoSettings; all other settings come with the mesh. */
    LegoNodeContender(std::string name, std::string settings);

    std::string getName() const override { return _name; }
    bool hasColors() const override { return true; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() override;
    Stages getStages() const override;
    osg::ref_ptr<const BrickModel> getBricks() override;
    void release() override;

private:
    void createView();
    std::string drawFrame();
    void stampTime(std::size_t end) const;

    std::string _name;
    std::string _settings;
    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<osg::FrameStamp> _frameStamp;
    osg::ref_ptr<osgUtil::SceneView> _view;
    std::array<GlQuery, 2> _timeStamps; // at the start and end of a frame; unused if the renderer has no clock
};

} // namespace osgLego
