#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the table of the light that a stud hides from bricks and from the walls of other studs, found by rays; the
 * companion of createOcclusionTable(), whose falloff it has. Rays that meet the brick of the stud before it do not
 * count.
 *
 * The image has 32 x 32 texels in four bands of 8 lines. Each texel is an integral over the hidden directions: red of
 * their weight, a fraction of the sky; green, blue and alpha of the direction, along the receiving surface towards the
 * stud, up, and along the normal of the surface. Values are divided by 0.5; that of blue, which may be negative, is
 * halved, and 0.5 is added.
 *
 * - Lines 0 to 7: a side of a brick whose foot is level with the stud's, half a pitch from the axis of the stud.
 * Columns are horizontal distances from the axis, along the surface, from 0 to 1.5 pitches; lines are heights, from 0
 * to that of a cell.
 * - Lines 8 to 15: the wall of another stud, one pitch away on the same level. Columns are cosines of the angle between
 *   its normal and the direction from stud to stud, from 1 to -1; lines are heights, from 0 to that of a stud.
 * - Lines 16 to 23: likewise, at the distance of a diagonal neighbour.
 * - Lines 24 to 31, which are equal: a surface on the level of the stud, whose normal is up. Columns are square roots
 * of distances from the wall, whose square is 0 to 1 between the radius of a stud and 1.5 pitches from the axis: most
 *   changes near the wall.
 *
 * May be called from any thread.
 * @param height of a cell, in pitches. @param radius the greatest distance of occluders, in pitches. */
osg::ref_ptr<osg::Image> createStudOcclusion(double height, double radius);

} // namespace osgLego
