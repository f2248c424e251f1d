#pragma once

#include <osgLego/LayoutStatistics.h>
#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/Join.h>
#include <osgLego/model/JoinSearch.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/RecoloringCosts.h>
#include <osgLego/search/LayoutOptions.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace osgLego
{

/** Cells, the parts that cover them, and the cells that were added to join pieces. */
struct JoinedLayout
{
    LayoutProblem problem;
    LaidParts parts;
    std::vector<glm::ivec3> added; //!< cells that join pieces
};

/** Joins the pieces of a layout to one, by as few changes of its cells as it finds.
 *
 * In each round, every piece but the largest looks for its cheapest join to another one (JoinSearch): cells in another
 * colour, or additional cells, hidden ones first. Parts around these are laid again. Joins that fail become more
 * expensive. Rounds end when one piece is left, when no piece can be joined, or when MOST_FAILURES rounds in a row have
 * joined none. They are then repeated once, and go on from layouts in which all joins hold but as many other parts came
 * loose, which may be easier to join. Rounds use at most normal effort; with Effort::BEST, parts around all changes are
 * laid again at the end.
 *
 * Usage:
 *
 *     const RecoloringCosts costs(*cells, colors);
 *     JoinedLayout layout{problem, parts};
 *     ConnectionBuilder builder(options, costs);
 *     if (!builder.build(layout)) ... // cancelled
 *
 * The result is the same for any number of threads. The costs must exist as long as this object. */
class ConnectionBuilder
{
public:
    static constexpr int MOST_FAILURES = 10;

    /** @param options for layouts; its progress is called after each round that has joined pieces, with the share of
     * the pieces at the beginning that are part of another one by then. */
    ConnectionBuilder(const LayoutOptions& options, const RecoloringCosts& costs);

    /** Change cells and parts. @return false if it was cancelled. */
    bool build(JoinedLayout& layout);

    /** The figures of the last build(), apart from the time. */
    const ConnectionStatistics& getStatistics() const { return _statistics; }

private:
    bool isCancelled() const { return _options.isCancelled && _options.isCancelled(); }
    bool joinPieces(JoinedLayout& layout, bool joinsOthers);
    std::vector<Join> findJoins(const JoinedLayout& layout, const LayoutPieces& pieces) const;
    bool improve(JoinedLayout& layout, std::vector<glm::ivec3> changed);
    std::optional<JoinedLayout> layAgain(const JoinedLayout& layout, const std::vector<Join>& joins,
                                         const glm::ivec3& reach);
    void penalizeFailed(const std::vector<Join>& joins, const LayoutPieces& pieces, bool isBetter, double penalty);
    void penalize(const Join& join, double penalty);

    std::function<void(double)> _progress;
    LayoutOptions _options;
    LayoutOptions _roundOptions; //!< at most normal effort, which shows as well whether a join holds
    const RecoloringCosts& _costs;
    JoinSearch::Penalties _penalties;
    ConnectionStatistics _statistics;
};

} // namespace osgLego
