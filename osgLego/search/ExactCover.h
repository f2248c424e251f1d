#pragma once

#include <osgLego/search/WindowParts.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

/** Finds the cheapest cover of a window: a set of parts that contains each cell once.
 *
 * Depth-first branch and bound: the first uncovered cell is covered by each part that begins there. A feasible solution
 * of the dual of the linear program, prices of cells whose sum over a part is at most the part's cost, gives both a
 * bound and an order: a cover costs the sum of all prices plus the reduced costs of its parts, which are not negative.
 * A table of sets of uncovered cells prunes sets that an earlier step reached at a lower cost.
 *
 * Keeps its memory from one call to the next. One thread at a time. */
class ExactCover
{
public:
    /** Find the cheapest cover that costs less than `limit`. Give up after `maximumNodes` steps.
     * @param chosen the indices of its parts; unchanged if the function returns false. */
    bool findCheaper(const WindowParts& window, int limit, int maximumNodes, std::vector<int>& chosen);

    /** The number of steps of the last search. */
    int getNumNodes() const { return _numNodes; }

private:
    struct Known
    {
        WindowCells uncovered;
        int cost = 0;
        std::uint32_t search = 0;
    };

    /** A part that may cover the first uncovered cell. */
    struct Choice
    {
        int cost = 0; //!< reduced
        int part = 0;
    };

    int computePrices(int limit);
    bool sortParts();
    bool isKnown(const WindowCells& uncovered, int cost);
    void search(const WindowCells& uncovered, int cost);

    const WindowParts* _window = nullptr;
    std::vector<int> _reducedCosts;
    std::vector<Choice> _order;    //!< sorted by reduced cost for each first cell
    std::vector<int> _orderStarts; //!< for each cell, its first choice; then the number of choices
    std::vector<int> _users;       //!< the parts that contain a cell, cell by cell
    std::vector<int> _userStarts;
    std::vector<int> _cells; //!< in the order in which they get their prices
    std::vector<Known> _known;
    std::uint32_t _numSearches = 0;
    std::vector<int> _path;
    std::vector<int> _best;
    int _limit = 0; //!< for the sum of reduced costs
    int _numNodes = 0;
    int _maximumNodes = 0;
};

} // namespace osgLego
