#pragma once

#include <osgLego/Export.h>

#include <string>

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The ambient occlusion of bricks in the full look. */
enum class BrickOcclusion
{
    OFF,    //!< none
    GRID,   //!< by the other bricks of their node: found in the grid, everywhere
    SCREEN, //!< by everything in the picture, below an AmbientOcclusionScene; elsewhere none
    BOTH    //!< the default: GRID and, below an AmbientOcclusionScene, by other nodes in the picture
};

/** The appearance of bricks in the full look (Look::FULL): joints, relief, plastic and variation.
 *
 * A plain value: copy it, change members, pass it to LegoNode::setAppearance, which checks it. A change does not cause
 * a new legolization.
 *
 * Usage:
 *
 *     osgLego::BrickAppearance appearance;
 *     appearance.variation = 0.0;                                     // all bricks alike
 *     appearance.reliefImage = osgDB::readRefImageFile("emblem.png"); // instead of the built-in cube
 *     lego->setAppearance(appearance);
 *
 * Every function may be called from any thread on an object that no other thread is changing.
 */
struct OSGLEGO_EXPORT BrickAppearance
{
    /** Whether edges are rounded, which forms joints between bricks (the paper, section III-D). */
    bool joints = true;
    /** The height of the relief on studs, in radii of the stud's disk: 0 (none) to 0.2. */
    double reliefHeight = 0.05;
    /** The height map of the relief: the first channel of an uncompressed 2D image, where black is lowest. The circle
     * inscribed in the image is the stud's disk. At most 2048 pixels along a side. Null: the built-in relief, a cube
     * seen along its diagonal. */
    osg::ref_ptr<const osg::Image> reliefImage;
    /** The perceptual roughness of the plastic, 0.05 to 1: the square root of the slope of its microfacets. */
    double roughness = 0.25;
    /** The variation of shade and tilt from brick to brick, 0 (none) to 5; 1 is the variation of real bricks, 3 % and a
     * third of a degree. It depends only on the brick's cell. */
    double variation = 1.0;
    /** Whether highlights are those of the osg::Material in the state above the node (specular, shininess), instead of
     * those of plastic. */
    bool materialSpecular = false;
    /** The width of lines at the edges of parts and studs, in pixels, 0 (none) to 8: dark, or light on dark parts, as
     * in building instructions. With them, parts are drawn hollow below. Also in the plain look. */
    double outline = 0.0;
    /** The occluders of bricks. The grid has no noise and takes no pass over the picture: near occlusion comes from one
     * cell to each side of a face, and three in front of it; of a model partly built, from those in place. Bricks
     * occlude other nodes below an AmbientOcclusionScene with each of these values. */
    BrickOcclusion occlusion = BrickOcclusion::BOTH;
    /** Whether the grid also has the occlusion by bricks farther away than 2.5 bricks, for GRID and BOTH; see
     * AmbientOcclusionSettings::distant, which leaves it out, too. Of a model partly built, it is that of the whole
     * model times the share of parts in place; while bricks change several times a second, it is that of earlier
     * bricks unless LegoNode::setWaiting(). */
    bool distantOcclusion = true;

    /** The first error in these values, with the expected value, in one sentence; empty if there is none. */
    std::string check() const;

    bool operator==(const BrickAppearance&) const = default;
};

} // namespace osgLego
