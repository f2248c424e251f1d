#pragma once

#include "Contender.h"

#include <string>
#include <vector>

namespace osgLego
{

/** A mesh to measure with, by name. */
struct MeshSource
{
    std::string name;
    std::string path; //!< empty: the built-in car
    UpAxis upAxis = UpAxis::Z;

    /** Read `path`, `name=path` or `car`, each with `,up=y` or `,up=z` behind it if wanted. Throws std::runtime_error.
     */
    static MeshSource parse(const std::string& text);
    /** What parse() makes this of. */
    std::string toString() const;
};

/** The built-in car, and the meshes (.ply, .dae) of a folder in the order of their names. */
std::vector<MeshSource> findMeshSources(const std::string& folder);

/** The Stanford bunny of a folder, or the built-in car where it is not there. */
MeshSource findBunny(const std::string& folder);

/** Read a mesh; one without colours is given some by vertex, from where the vertex lies, so that nobody is spared the
 * work of colours. Throws std::runtime_error when it can't be read or has no triangles. */
osg::ref_ptr<osg::Node> readMesh(const MeshSource& source);

/** Lay a grid around a mesh that was read. */
BenchMesh createBenchMesh(const MeshSource& source, osg::Node& node, unsigned int resolution);

} // namespace osgLego
