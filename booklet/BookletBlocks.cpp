#include "BookletBlocks.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace osgLego
{

namespace
{

void addCopies(const std::vector<BookletItem>& items, std::size_t quantity, std::vector<BookletItem>& sum)
{
    for (const BookletItem& item : items)
        sum.push_back({item.kind, quantity * item.quantity});
}

} // namespace

BookletBlocks::BookletBlocks(const BookletModel& model, const std::vector<bool>& isWhole)
{
    for (std::size_t step = 0; step < model.getMainChapter().steps.size(); ++step)
    {
        BookletBlock block;
        block.step = step;
        block.mainStep = step;
        addStep(model, isWhole, block);
    }
}

/** Add the submodels that a step attaches, and then the step. */
void BookletBlocks::addStep(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block)
{
    const BookletStep& step = model.getChapters()[block.chapter].steps[block.step];
    for (const std::size_t submodel : model.getOriginals(step))
    {
        if (model.getChapters()[submodel].isCallout()) continue;
        BookletBlock own = block;
        own.chapter = submodel;
        addSubmodel(model, isWhole, std::move(own));
    }
    addCopies(step.items, block.quantity, block.placed);
    for (const std::size_t submodel : step.submodels)
        if (const BookletChapter& own = model.getChapters()[submodel]; own.isCallout())
            addCopies(own.items, block.quantity, block.placed);
    _blocks.push_back(std::move(block));
}

/** Add the contents of a submodel, and then its steps. No bag begins among those of a submodel that is built several
 * times. */
void BookletBlocks::addSubmodel(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block)
{
    const BookletChapter& own = model.getChapters()[block.chapter];
    block.step = 0;
    block.quantity *= own.quantity;
    // A list and a picture of the same parts, twice, would seem to be twice the parts.
    block.isSubmodel = own.steps.size() == 1 && own.quantity == 1 && !isWhole[block.chapter];
    if (!block.isSubmodel)
    {
        addContents(model, isWhole, block);
        ++block.numOpen;
    }
    block.isDivisible = block.quantity == 1;
    for (; block.step < own.steps.size() && !isWhole[block.chapter]; ++block.step)
        addStep(model, isWhole, block);
}

void BookletBlocks::addContents(const BookletModel& model, const std::vector<bool>& isWhole, BookletBlock block)
{
    const BookletChapter& own = model.getChapters()[block.chapter];
    block.isContents = true;
    if (own.isListed()) list(model, block);
    if (isWhole[block.chapter]) addCopies(own.items, block.quantity, block.placed);
    _blocks.push_back(std::move(block));
}

/** List the contents of a submodel. Parts of submodels of many parts within it are in the lists of these, so that the
 * builder gathers each part once. */
void BookletBlocks::list(const BookletModel& model, BookletBlock& contents)
{
    std::vector<BookletItem> placed;
    for (const BookletStep& step : model.getChapters()[contents.chapter].steps)
    {
        addCopies(step.items, 1, placed);
        for (const std::size_t submodel : step.submodels)
            if (const BookletChapter& inner = model.getChapters()[submodel]; inner.isCallout())
                addCopies(inner.items, 1, placed);
            else if (inner.original == submodel)
                contents.submodels.push_back(submodel);
    }
    std::map<std::size_t, std::size_t> quantities;
    for (const BookletItem& item : placed)
        quantities[item.kind] += item.quantity;
    for (const auto& [kind, quantity] : quantities)
        contents.items.push_back({kind, quantity});
}

std::vector<BookletBlock> BookletBlocks::select(std::size_t firstBlock, std::size_t endBlock, std::size_t firstStep,
                                                std::size_t endStep) const
{
    std::vector<BookletBlock> blocks;
    std::copy_if(_blocks.begin() + static_cast<std::ptrdiff_t>(firstBlock),
                 _blocks.begin() + static_cast<std::ptrdiff_t>(endBlock), std::back_inserter(blocks),
                 [&](const BookletBlock& block) { return block.mainStep >= firstStep && block.mainStep < endStep; });
    return blocks;
}

std::size_t sumQuantities(const std::vector<BookletItem>& items)
{
    return std::accumulate(items.begin(), items.end(), std::size_t{0},
                           [](std::size_t number, const BookletItem& item) { return number + item.quantity; });
}

} // namespace osgLego
