#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego::test
{

/** Triangles, three vertices each. */
using GridVertices = std::vector<GridVertex>;

/** Surfaces without borders: random tetrahedra of 0.1 to 50 cells in a cube of 64 cells, among them slivers, and, on
 * request, some with coinciding or collinear corners. Texture coordinates and colours are linear functions of the
 * position. Equal seeds give equal triangles. */
GridVertices createTetrahedra(std::uint32_t seed, int count, bool withDegenerateOnes);

/** The result of a subdivision. */
struct FineTriangles
{
    GridVertices vertices;
    std::size_t numPasses = 0; //!< those that cut a triangle
};

/** Cut triangles pass by pass, as the paper's Algorithms 1 and 2 do. */
FineTriangles subdivideOnCpu(const GridVertices& source, double edgeLimit);

/** The largest number of passes that triangles can take. */
std::size_t mostPasses(const GridVertices& source, double edgeLimit);

/** Expect that every source triangle has the same area, as a vector along its normal, as its fine triangles. */
void expectSameAreas(const GridVertices& source, const GridVertices& fine);
/** Expect that every fine triangle faces in the direction of its source triangle, and lies in its plane. */
void expectSameNormals(const GridVertices& source, const GridVertices& fine);
/** Expect that each edge is also an edge of another triangle, in the other direction, as in a surface without borders.
 */
void expectNoCracks(const GridVertices& triangles);
/** Expect that no edge is longer than the limit. */
void expectShortEdges(const GridVertices& triangles, double edgeLimit);
/** Expect the texture coordinates and colours of createTetrahedra() at every vertex. */
void expectLinearAttributes(const GridVertices& triangles, double colorTolerance);

} // namespace osgLego::test
