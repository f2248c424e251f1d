#pragma once

#include "BookletModel.h"

#include <cstddef>
#include <vector>

namespace osgLego
{

/** A step, or the contents of a submodel of many parts. */
struct BookletBlock
{
    std::size_t chapter = 0;
    std::size_t step = 0;
    bool isContents = false;
    bool isSubmodel = false;        //!< whether it is the only step of a submodel, which also stands for its contents
    std::size_t quantity = 1;       //!< how often it is built
    std::size_t mainStep = 0;       //!< the step of the main model that it belongs to
    std::size_t numOpen = 0;        //!< the submodels that have begun, but are not finished, before it
    bool isDivisible = true;        //!< whether a bag may begin with it
    std::vector<BookletItem> items; //!< that contents list, without those of `submodels`; none if they are too many
    std::vector<std::size_t> submodels; //!< of many parts that contents list, likewise
    bool isContinued = false;           //!< whether the list is the rest of one that is too long for a sheet
    std::vector<BookletItem> placed;    //!< the parts that a builder places by it, in all copies
};

/** Everything that is built in a booklet, in the order of building. Submodels of few parts belong to the step that
 * attaches them.
 *
 *     for (const BookletBlock& block : BookletBlocks(model, isWhole).getBlocks()) ...
 *
 * Uses no GL. Immutable; every function may be called from any thread. */
class BookletBlocks
{
public:
    /** @param isWhole for each chapter, whether its contents show all its steps. */
    BookletBlocks(const BookletModel& model, const std::vector<bool>& isWhole);

    const std::vector<BookletBlock>& getBlocks() const { return _blocks; }
    /** Those of some blocks that belong to some steps of the main model. */
    std::vector<BookletBlock> select(std::size_t firstBlock, std::size_t endBlock, std::size_t firstStep,
                                     std::size_t endStep) const;

private:
    void addStep(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block);
    void addSubmodel(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block);
    void addContents(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block);
    static void list(const BookletModel& model, BookletBlock& contents);

    std::vector<BookletBlock> _blocks;
};

/** The sum of the quantities of items. */
std::size_t sumQuantities(const std::vector<BookletItem>& items);

} // namespace osgLego
