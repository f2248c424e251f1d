#pragma once

#include "Contender.h"

#include <string>
#include <vector>

namespace osgLego
{

/** A mesh to measure with. */
struct MeshSource
{
    std::string name = "car";
    std::string path = "car"; //!< "car" and "stair", ten steps of a brick at a resolution of 10, are built in
    UpAxis upAxis = UpAxis::Z;

    /** Read `path`, `name=path` or `car`, each optionally followed by `,up=y` or `,up=z`. Throws std::runtime_error.
     */
    static MeshSource parse(const std::string& text);
    bool isFile() const { return path != "car" && path != "stair"; }
};

/** The built-in car, and the meshes (.ply, .dae) of a folder in the order of their names. */
std::vector<MeshSource> findMeshSources(const std::string& folder);

/** The Stanford bunny of a folder, or the built-in car where it is missing. */
MeshSource findBunny(const std::string& folder);

/** Read a mesh. A mesh without colours gets colours per vertex, from the vertex's position, so that every method has to
 * handle colours. Throws std::runtime_error if it can't be read or has no triangles. */
osg::ref_ptr<osg::Node> readMesh(const MeshSource& source);

/** Create the grid for a mesh that has been read. */
BenchMesh createBenchMesh(const MeshSource& source, osg::Node& node, unsigned int resolution);

} // namespace osgLego
