#include <osgLego/search/ExactCover.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace osgLego
{

namespace
{

constexpr std::size_t NUM_KNOWN = 4096; // a power of two

} // namespace

/** Raise the price of each cell as far as the parts that contain it allow, first that of cells in the fewest parts.
 * @return the sum of the prices, or of enough of them to reach `limit`. */
int ExactCover::computePrices(int limit)
{
    const std::vector<WindowPart>& parts = _window->parts;
    const auto numCells = static_cast<std::size_t>(_window->getNumCells());
    _userStarts.assign(numCells + 1, 0);
    _reducedCosts.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        _reducedCosts[i] = parts[i].cost;
        parts[i].cells.visit([&](int cell) { ++_userStarts[static_cast<std::size_t>(cell)]; });
    }
    _cells.resize(numCells);
    for (std::size_t cell = 0; cell < numCells; ++cell)
        _cells[cell] = static_cast<int>(cell);
    std::sort(_cells.begin(), _cells.end(),
              [&](int a, int b)
              {
                  const int usersOfA = _userStarts[static_cast<std::size_t>(a)];
                  const int usersOfB = _userStarts[static_cast<std::size_t>(b)];
                  return usersOfA != usersOfB ? usersOfA < usersOfB : a < b;
              });
    for (std::size_t cell = 0; cell < numCells; ++cell)
        _userStarts[cell + 1] += _userStarts[cell];
    _users.resize(static_cast<std::size_t>(_userStarts[numCells]));
    for (std::size_t i = parts.size(); i-- > 0;)
        parts[i].cells.visit(
            [&](int cell)
            { _users[static_cast<std::size_t>(--_userStarts[static_cast<std::size_t>(cell)])] = static_cast<int>(i); });

    int sum = 0;
    for (const int cell : _cells)
    {
        const auto begin = _users.begin() + _userStarts[static_cast<std::size_t>(cell)];
        const auto end = _users.begin() + _userStarts[static_cast<std::size_t>(cell) + 1];
        if (begin == end) return std::numeric_limits<int>::max(); // there is no cover
        int price = std::numeric_limits<int>::max();
        for (auto user = begin; user != end; ++user)
            price = std::min(price, _reducedCosts[static_cast<std::size_t>(*user)]);
        for (auto user = begin; user != end && price > 0; ++user)
            _reducedCosts[static_cast<std::size_t>(*user)] -= price;
        sum += price;
        if (sum >= limit) break;
    }
    return sum;
}

/** Sort the parts that begin at each cell by their reduced costs. Parts that cost the limit or more are in no cover
 * that the search may find.
 * @return false if no other parts begin at the first cell, so that there is no such cover. */
bool ExactCover::sortParts()
{
    const std::vector<int>& starts = _window->starts;
    _order.clear();
    _orderStarts.assign(1, 0);
    for (std::size_t cell = 0; cell + 1 < starts.size(); ++cell)
    {
        for (int part = starts[cell + 1]; part-- > starts[cell];)
            if (const int cost = _reducedCosts[static_cast<std::size_t>(part)]; cost < _limit)
                _order.push_back({cost, part});
        const auto begin = _order.begin() + _orderStarts.back();
        // Of equal costs, the last part comes first.
        std::sort(begin, _order.end(),
                  [](const Choice& a, const Choice& b)
                  { return a.cost != b.cost ? a.cost < b.cost : a.part > b.part; });
        _orderStarts.push_back(static_cast<int>(_order.size()));
    }
    return _orderStarts.size() < 2 || _orderStarts[1] > 0;
}

/** Whether an earlier step reached the same set of uncovered cells at this cost or less. If not, remember the set. */
bool ExactCover::isKnown(const WindowCells& uncovered, int cost)
{
    constexpr std::size_t PROBES = 4;
    const std::size_t hash = uncovered.getHash();
    for (std::size_t probe = 0; probe < PROBES; ++probe)
    {
        Known& known = _known[(hash + probe) % NUM_KNOWN];
        if (known.search == _numSearches && known.uncovered == uncovered)
        {
            if (known.cost <= cost) return true;
            known.cost = cost;
            return false;
        }
        if (known.search != _numSearches)
        {
            known = {uncovered, cost, _numSearches};
            return false;
        }
    }
    return false;
}

void ExactCover::search(const WindowCells& uncovered, int cost)
{
    if (uncovered.isEmpty())
    {
        _limit = cost;
        _best = _path;
        return;
    }
    ++_numNodes;
    if (isKnown(uncovered, cost)) return;
    const auto first = static_cast<std::size_t>(uncovered.getFirst());
    for (int i = _orderStarts[first]; i < _orderStarts[first + 1]; ++i)
    {
        const auto [reducedCost, part] = _order[static_cast<std::size_t>(i)];
        const int sum = cost + reducedCost;
        if (sum >= _limit || _numNodes > _maximumNodes) return;
        const WindowCells& cells = _window->parts[static_cast<std::size_t>(part)].cells;
        if (!uncovered.includes(cells)) continue;
        _path.push_back(part);
        search(uncovered.without(cells), sum);
        _path.pop_back();
    }
}

bool ExactCover::findCheaper(const WindowParts& window, int limit, int maximumNodes, std::vector<int>& chosen)
{
    _window = &window;
    _numNodes = 0;
    const int prices = computePrices(limit);
    if (prices >= limit) return false;
    _limit = limit - prices;
    if (!sortParts()) return false;
    if (_known.empty()) _known.resize(NUM_KNOWN);
    ++_numSearches;
    _maximumNodes = maximumNodes;
    _best.clear();
    WindowCells all;
    for (int cell = 0; cell < window.getNumCells(); ++cell)
        all.add(cell);
    search(all, 0);
    if (_best.empty()) return false;
    chosen = _best;
    return true;
}

} // namespace osgLego
