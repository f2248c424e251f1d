#pragma once

#include <osgLego/ModelDesign.h>

#include <cstddef>
#include <vector>

namespace osgLego
{

/** The order of the models that designModel() compares. */
class DesignRanking
{
public:
    /** @param mostParts models with more parts come after those that are as sound and have few enough. */
    explicit DesignRanking(std::size_t mostParts) : _mostParts(mostParts) {}

    /** 0 for models that a builder can rely on, more for others. */
    static int rankStability(const StabilityReport& stability);
    static bool standsSafely(const DesignCandidate& candidate) { return rankStability(candidate.stability) == 0; }
    bool hasFewEnoughParts(const DesignCandidate& candidate) const { return candidate.layout.numParts <= _mostParts; }

    /** Models of one piece before others, then those that stand, those that have few enough parts, those of fewer
     * pieces, those easy to build, as far as it is known, and those more like the mesh; among those
     * that look alike, the one of fewer parts, or of fewer settings. */
    bool isBetter(const DesignCandidate& a, const DesignCandidate& b) const;

    /** The models that fall, are not supported yet, and are clearly more like the mesh than the best that stands
     * safely, if any. Bricks and plates alternate, since models of the same proportions often fall for the same reason.
     *
     * @param candidates in this order; not empty. */
    static std::vector<const DesignCandidate*> listFallingBetter(const std::vector<DesignCandidate>& candidates);

    /** The settings of models of one piece, not supported yet, that fall, or whose plan exceeds the limits: those most
     * like the mesh first, in alternation as above. No models that are too large to be planned. */
    static std::vector<LegoSettings> listHard(const std::vector<DesignCandidate>& candidates);

private:
    std::size_t _mostParts;
};

} // namespace osgLego
