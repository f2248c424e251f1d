#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace osgLego
{

/** The cells of a box of which isCell(x, y, z) returns a colour; none where it returns -1. */
LayoutProblem makeCells(const glm::ivec3& size, const std::function<int(int, int, int)>& getColor,
                        std::vector<LayoutColor> colors = {LayoutColor{}});

/** Random cells in patches of random colours; one of the colours is ANY_COLOR. */
LayoutProblem makeRandomCells(const glm::ivec3& size, int percent, std::uint32_t seed,
                              std::vector<LayoutColor> colors = std::vector<LayoutColor>(3));

/** A dome, one or more cells thick. */
LayoutProblem makeDome(int radius, int thickness);

/** A layout that tests examine by brute force. */
class LaidModel
{
public:
    LaidModel(const LayoutProblem& problem, const LaidParts& parts);

    /** The first error in the parts: a cell that no part or two parts cover, a size that was never made (except for
     * single cells), or a wrong colour. Empty if there is none. */
    std::string findMistake() const;
    /** The number of components of parts with a stud under another. */
    int countComponents() const;
    /** Parts that touch only one other part above and below. */
    int countLeaves() const;
    /** Unit joints that lie above a joint of other parts. */
    int countStackedSeams() const;

private:
    std::set<std::pair<int, int>> findContacts() const;
    std::string findMistake(const LaidPart& part) const;

    const LayoutProblem& _problem;
    const LaidParts& _parts;
    std::map<std::array<int, 3>, std::uint16_t> _colors;
    std::map<std::array<int, 3>, int> _owners;
    int _numCovered = 0;
};

} // namespace osgLego
