#pragma once

#include <osgLego/passes/PassPlan.h>

#include <osg/Program>
#include <osg/Referenced>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The images that DominantColorPass reads and draws into, and its program, which the passes of all slabs share. */
class DominantColorTargets : public osg::Referenced
{
public:
    /** @param sums the voxel image of VoxelizationPass. */
    DominantColorTargets(const PassPlan& plan, osg::Texture2D& sums);

    osg::Program& getProgram() const { return *_program; }
    osg::Texture2D& getSums() const { return *_sums; }
    osg::Texture2D& getColors() const { return *_colors; }
    osg::Texture2D& getDepths() const { return *_depths; }

private:
    ~DominantColorTargets() override = default;

    osg::ref_ptr<osg::Program> _program;
    osg::ref_ptr<osg::Texture2D> _sums;
    osg::ref_ptr<osg::Texture2D> _colors;
    osg::ref_ptr<osg::Texture2D> _depths;
};

} // namespace osgLego
