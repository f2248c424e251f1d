#pragma once

#include <osgLego/Palette.h>
#include <osgLego/palette/ColorHistogram.h>

namespace osgLego
{

/** Choose the colours of a palette with which a surface is shown best: those with the least weighted sum of the squared
 * differences (CIEDE2000 between places of toMatchingLab()) between each colour of the surface and the nearest chosen
 * colour.
 *
 * The colours are added one after the other, each time the one that helps most, and then exchanged as long as an
 * exchange helps (k-medoids; Kaufman and Rousseeuw 1990, with all exchanges of one colour evaluated together as by
 * Schubert and Rousseeuw 2019). The same arguments give the same palette, and equal choices may share one. May be
 * called from any thread.
 * @param count 1 or more.
 * @return `count` colours in the order of the palette; the palette itself if it has no more than that. */
osg::ref_ptr<const Palette> chooseColors(const Palette& palette, const ColorHistogram& histogram, std::size_t count);

} // namespace osgLego
