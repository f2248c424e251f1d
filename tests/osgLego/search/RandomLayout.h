#pragma once

#include "../layout/LaidMap.h"

#include <Layouts.h>

#include <osgLego/search/LayoutRegion.h>

#include <random>
#include <string>

namespace osgLego
{

/** Random cells, covered by random parts. */
struct RandomLayout : LaidMap
{
    /** @param characters those of drawProblem(). */
    RandomLayout(const std::string& characters, bool isOfPlates, unsigned int seed) :
        RandomLayout({7, 6, 5}, characters, isOfPlates, seed, std::mt19937(seed))
    {
    }

    /** @param random of the parts. */
    RandomLayout(const glm::ivec3& size, const std::string& characters, bool isOfPlates, unsigned int seed,
                 auto&& random) :
        LaidMap(makeProblem(size, characters, isOfPlates, seed))
    {
        layRandomly(random);
    }

    static LayoutProblem makeProblem(const glm::ivec3& size, const std::string& characters, bool isOfPlates,
                                     unsigned int seed)
    {
        LayoutProblem cells = createRandomProblem(size, characters, seed);
        cells.isOfPlates = isOfPlates;
        return cells;
    }

    LayoutRegion region{0, problem.size.z, 0, problem.size.y, 0, 0, nullptr};
};

} // namespace osgLego
