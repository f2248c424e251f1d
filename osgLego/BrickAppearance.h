#pragma once

#include <osgLego/Export.h>

#include <string>

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** How bricks are made to look like bricks, in the full look (Look::FULL).
 *
 * A plain value: copy it, change members, hand it to LegoNode::setAppearance, which checks it. A change costs no
 * legolization.
 *
 * Usage:
 *
 *     osgLego::BrickAppearance appearance;
 *     appearance.variation = 0.0;                                     // every brick like the other
 *     appearance.reliefImage = osgDB::readRefImageFile("emblem.png"); // in place of the project's cube
 *     lego->setAppearance(appearance);
 *
 * Every function may be called from any thread on an object that no other thread is changing.
 */
struct OSGLEGO_EXPORT BrickAppearance
{
    /** Whether edges are rounded, which makes joints of those between bricks (the paper, section III-D). */
    bool joints = true;
    /** How high the relief on studs stands, in radii of the stud's disk: 0 (none) to 0.2. */
    double reliefHeight = 0.05;
    /** Heights of the relief, by the image's first channel, black lowest; its inscribed circle is the stud's disk.
     * Null: the project's own relief, a cube seen along its diagonal. At most 2048 pixels along a side. */
    osg::ref_ptr<const osg::Image> reliefImage;
    /** How rough the plastic is, 0.05 to 1, as perceived: the square root of the slope of its microfacets. */
    double roughness = 0.25;
    /** How much bricks differ from each other in shade and tilt, by their cells: 0 (not at all) to 5; 1 is what real
     * ones do, 3 % and a third of a degree. */
    double variation = 1.0;
    /** Highlights by the osg::Material of the state above the node (specular, shininess), instead of plastic's. */
    bool materialSpecular = false;

    /** What is wrong with these values and what is allowed instead, in one sentence; empty when nothing is. */
    std::string check() const;

    bool operator==(const BrickAppearance&) const = default;
};

} // namespace osgLego
