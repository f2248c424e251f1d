#include "BookletBags.h"

#include <limits>
#include <map>
#include <numeric>

namespace osgLego
{

namespace
{

std::vector<BookletItem> countItems(const BookletModel& model, const BookletBag& bag)
{
    std::map<std::size_t, std::size_t> quantities;
    const auto add = [&quantities](const std::vector<BookletItem>& items)
    {
        for (const BookletItem& item : items)
            quantities[item.kind] += item.quantity;
    };
    for (std::size_t index = bag.firstStep; index < bag.endStep; ++index)
    {
        const BookletStep& step = model.getMainChapter().steps[index];
        add(step.items);
        for (const std::size_t submodel : step.submodels)
            add(model.getChapters()[submodel].items);
    }
    std::vector<BookletItem> items;
    items.reserve(quantities.size());
    for (const auto& [kind, quantity] : quantities)
        items.push_back({kind, quantity});
    return items;
}

/** Divide steps so that bags differ least from the usual number of parts, by the sum of squares. All steps are never
 * one bag, unless there is only one step. @return the ends of the bags. */
std::vector<std::size_t> divideSteps(const std::vector<BookletStep>& steps)
{
    const std::size_t number = steps.size();
    std::vector<double> costs(number + 1, std::numeric_limits<double>::max());
    std::vector<std::size_t> firsts(number + 1, 0);
    costs[0] = 0.0;
    for (std::size_t end = 1; end <= number; ++end)
        for (std::size_t first = end == number && number > 1 ? 1 : 0; first < end; ++first)
        {
            const std::size_t numParts = steps[end - 1].numPlaced - (first == 0 ? 0 : steps[first - 1].numPlaced);
            const double excess = static_cast<double>(numParts) - static_cast<double>(BookletBag::USUAL_PARTS);
            const double cost = costs[first] + excess * excess;
            if (cost >= costs[end]) continue;
            costs[end] = cost;
            firsts[end] = first;
        }
    std::vector<std::size_t> ends;
    for (std::size_t end = number; end > 0; end = firsts[end])
        ends.insert(ends.begin(), end);
    return ends;
}

} // namespace

std::size_t BookletBag::countParts() const
{
    return std::accumulate(items.begin(), items.end(), std::size_t{0},
                           [](std::size_t number, const BookletItem& item) { return number + item.quantity; });
}

std::vector<BookletBag> createBags(const BookletModel& model)
{
    if (model.getNumParts() < BookletBag::LEAST_PARTS) return {};
    std::vector<BookletBag> bags;
    BookletBag bag;
    for (const std::size_t end : divideSteps(model.getMainChapter().steps))
    {
        bag.endStep = end;
        bag.items = countItems(model, bag);
        bags.push_back(bag);
        bag.firstStep = end;
    }
    return bags.size() > 1 ? bags : std::vector<BookletBag>();
}

} // namespace osgLego
