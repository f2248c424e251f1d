#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/GridTriangles.h>

#include <string>
#include <utility>
#include <vector>

#include <osg/GraphicsContext>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The input of contenders: one mesh in one grid. */
struct BenchMesh
{
    std::string name;
    osg::ref_ptr<osg::Node> node;
    LegoSettings settings; //!< the grid; contenders replace the settings of the method
    osg::ref_ptr<const GridTriangles> triangles;
};

/** A way of finding the bricks of a mesh, measured beside others.
 *
 * Preconditions:
 * 1. Every call comes from one thread, with one and the same context current.
 * 2. Its GL state is OSG's or the default. A contender restores the state that it changes.
 */
class Contender
{
public:
    /** Names of the stages of a run, and their milliseconds. */
    using Stages = std::vector<std::pair<std::string, double>>;

    virtual ~Contender() = default;

    /** Its name in tables and plots, a few lower-case words: "passalis", "exact, cpu". */
    virtual std::string getName() const = 0;
    virtual bool hasColors() const = 0;

    /** Make the objects that a program would make once for a mesh and a grid: programs, textures of the grid's size.
     * Not timed.
     * @return why it can't, in one sentence; empty when it can. */
    virtual std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) = 0;

    /** From triangles in main memory to points of the visible bricks (cell, colour, open sides, 12 bytes each) in a
     * buffer of the renderer.
     * @return milliseconds, the last command finished. */
    virtual double run() = 0;

    /** The stages of the last run, the same ones after every run; empty when there is only one. The stage "gpu" is the
     * time between two of GL's time stamps; software renderers have none. */
    virtual Stages getStages() const { return {}; }

    /** The cells that the last run found, visible or not. Not timed. */
    virtual osg::ref_ptr<const BrickModel> getBricks() = 0;

    /** Release the objects of prepare() and run(). */
    virtual void release() = 0;
};

} // namespace osgLego
