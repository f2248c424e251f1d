#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the table of the light that the cells in front of a brick's face hide from it, for each arrangement of these
 * cells: near occlusion as sums over 576 directions of each quadrant, without a picture.
 *
 * The directions above a face fall into four quadrants. Seen from inside the cell in front of the face, those of a
 * quadrant meet only the cells of the same quadrant: the column in front of the face, its two neighbours, and the one
 * between these. In three layers, and without the cell right in front of the face, which is empty, these are 11 cells:
 * 2048 patterns. Visibility and bent normal of a point are the sums of four entries.
 *
 * A direction whose ray first hits a cell at the distance t is hidden by the fraction clamp((radius - t) / (radius *
 * falloff), 0, 1), with the falloff of AmbientOcclusionSettings. For each position, a fixed set of directions is
 * sorted by the cells that hide them; subset sums then give all patterns.
 *
 * The image has a block of 8 x 8 texels for each pattern, 64 blocks in a row. Within a block,
 * texels are positions on the face, whose first and last are at the borders of the cell: red is visibility; green and
 * blue are the bent vector along the first and second axis of the face, alpha that along its normal; each is a fraction
 * of its value for an open quadrant, 1 / 4, 1 / (3 pi) and 1 / 6. The first quarter of the lines is for faces that are
 * perpendicular to the up axis, the second for the others, whose first axis is the horizontal one.
 *
 * The other two quarters, whose channels are equal, are for the occlusion that DistantOcclusion interpolates between
 * the middles of faces: the difference between the visibility of a point and the interpolated one, plus 128 / 255.
 * Texels are positions on the quarter of the face that is nearest to the cells of the pattern, from its middle to its
 * corner; beyond them, cells are repeated. The difference is 0 in the middle of a face, and equal at the edge of two
 * faces that are beside each other, as their patterns have the same columns there.
 * Bits of a pattern, from the lowest:
 *
 *     layer 1: first neighbour, second neighbour, both
 *     layer 2: own column, first neighbour, second neighbour, both
 *     layer 3: likewise
 *
 * May be called from any thread.
 * @param height of a cell, in pitches. @param radius the greatest distance of occluders, in pitches. */
osg::ref_ptr<osg::Image> createOcclusionTable(double height, double radius);

} // namespace osgLego
