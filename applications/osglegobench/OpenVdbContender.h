#pragma once

#include "BrickPointBuffer.h"
#include "Contender.h"

namespace osgLego
{

/** OpenVDB's meshToVolume, a distance field without colours, on two threads: a cell is covered when its centre is no
 * further than half a cell from the mesh. That has no tunnels, but misses what only grazes a cell. */
class OpenVdbContender : public Contender
{
public:
    /** What is asked of OpenVDB. */
    enum class Field
    {
        USUAL, //!< what meshToVolume gives by itself: signed, three cells to both sides
        NARROW //!< the least that it can do: unsigned, one cell
    };

    explicit OpenVdbContender(Field field) : _field(field) {}

    std::string getName() const override { return _field == Field::USUAL ? "openvdb" : "openvdb, narrow"; }
    bool hasColors() const override { return false; }
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) override;
    double run() override;
    osg::ref_ptr<const BrickModel> getBricks() override { return _bricks; }
    void release() override;

private:
    Field _field;
    osg::ref_ptr<const GridTriangles> _triangles;
    osg::ref_ptr<const BrickModel> _bricks;
    BrickPointBuffer _buffer;
};

} // namespace osgLego
