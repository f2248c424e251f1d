#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <string>

#include <osg/GraphicsContext>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** What contenders are given: one mesh in one grid. */
struct BenchMesh
{
    std::string name;
    osg::ref_ptr<osg::Node> node;
    LegoSettings settings; //!< the grid; what it says of methods is for the contender to replace
    osg::ref_ptr<const SceneTriangles> scene;
    osg::ref_ptr<const GridTriangles> triangles;
};

/** A way of finding the bricks of a mesh, to be measured beside others.
 *
 * Every call comes from one thread, with one and the same context current, its GL state OSG's or the default: what a
 * contender sets it sets back.
 */
class Contender
{
public:
    virtual ~Contender() = default;

    /** As tables and plots call it, in a few lower-case words: "passalis", "exact, cpu". */
    virtual std::string getName() const = 0;
    virtual bool hasColors() const = 0;

    /** Make what a program would make once for a mesh and a grid: programs, textures of the grid's size. Not timed.
     * @return why it can't, in one sentence; empty when it can. */
    virtual std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) = 0;

    /** From triangles in main memory to points of the visible bricks (cell, colour, open sides, 12 bytes each) in a
     * buffer of the renderer.
     * @return milliseconds that this took, the last command finished. */
    virtual double run() = 0;

    /** The cells that the last run found, whether or not they can be seen. Not timed. */
    virtual osg::ref_ptr<const BrickModel> getBricks() = 0;

    /** Let go of what prepare() and run() made. */
    virtual void release() = 0;
};

} // namespace osgLego
