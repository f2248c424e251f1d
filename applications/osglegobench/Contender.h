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

/** A method of finding the bricks of a mesh, to be compared with others.
 *
 * Preconditions:
 * 1. All functions are called from one thread, with the same context current.
 * 2. The GL state is OSG's or the default. A contender restores the state that it changes.
 */
class Contender
{
public:
    /** The names of the stages of a run, and their times in milliseconds. */
    using Stages = std::vector<std::pair<std::string, double>>;

    virtual ~Contender() = default;

    /** Its name in tables and plots, a few lower-case words: "passalis", "exact, cpu". */
    virtual std::string getName() const = 0;
    virtual bool hasColors() const = 0;

    /** Create the objects that an application would create once for a mesh and a grid: programs, textures of the grid's
     * size. Not timed.
     * @return an error message, in one sentence; empty on success. */
    virtual std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) = 0;

    /** Process the triangles in main memory into points of the visible bricks (cell, colour, open sides, 12 bytes each)
     * in a GL buffer, and wait for completion.
     * @return the duration in milliseconds. */
    virtual double run() = 0;

    /** The stages of the last run, the same ones after every run; empty if there is only one. The stage "gpu" is the
     * time between two GL time stamps; software renderers don't have it. */
    virtual Stages getStages() const { return {}; }

    /** The cells found by the last run, visible or not. Not timed. */
    virtual osg::ref_ptr<const BrickModel> getBricks() = 0;

    /** Release the objects of prepare() and run(). */
    virtual void release() = 0;
};

} // namespace osgLego
