#pragma once

#include "AssimpMaterials.h"

#include <string>

#include <assimp/mesh.h>
#include <osg/Geometry>
#include <osg/ref_ptr>

/** Create the geometry of a mesh: vertices, normals, colours, texture coordinates, and indexed triangles, lines or
 * points. A mesh without normals gets those of its triangles, as glTF requires.
 * @return null, with one sentence in `error`, if a vertex is not finite or an index is out of range. */
osg::ref_ptr<osg::Geometry> createAssimpGeometry(const aiMesh& mesh, const AssimpMaterials& materials,
                                                 std::string& error);
