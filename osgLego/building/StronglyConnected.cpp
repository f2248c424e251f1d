#include <osgLego/building/StronglyConnected.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

/** Tarjan's search with an explicit stack, since paths may have as many nodes as the graph. */
class TarjanSearch
{
public:
    TarjanSearch(std::size_t numNodes, const NextNodes& getNext) :
        _getNext(getNext), _numbers(numNodes, UNSEEN), _lowest(numNodes, 0), _isOpen(numNodes, false)
    {
        for (std::uint32_t node = 0; node < numNodes; ++node)
            if (_numbers[node] == UNSEEN) searchFrom(node);
    }

    std::vector<std::vector<std::uint32_t>> take() { return std::move(_groups); }

private:
    static constexpr std::uint32_t UNSEEN = 0xffffffff;

    void searchFrom(std::uint32_t start)
    {
        enter(start);
        while (!_path.empty())
        {
            auto& [node, numVisited] = _path.back();
            const std::span<const std::uint32_t> next = _getNext(node);
            if (numVisited < next.size())
            {
                const std::uint32_t other = next[numVisited++];
                if (_numbers[other] == UNSEEN)
                    enter(other);
                else if (_isOpen[other])
                    _lowest[node] = std::min(_lowest[node], _numbers[other]);
            }
            else
                leave();
        }
    }

    void enter(std::uint32_t node)
    {
        _numbers[node] = _lowest[node] = _numSeen++;
        _isOpen[node] = true;
        _open.push_back(node);
        _path.emplace_back(node, 0);
    }

    void leave()
    {
        const std::uint32_t node = _path.back().first;
        _path.pop_back();
        if (!_path.empty()) _lowest[_path.back().first] = std::min(_lowest[_path.back().first], _lowest[node]);
        if (_lowest[node] != _numbers[node]) return;
        const auto first = std::find(_open.rbegin(), _open.rend(), node).base() - 1;
        std::vector<std::uint32_t> group(first, _open.end());
        _open.erase(first, _open.end());
        for (const std::uint32_t member : group)
            _isOpen[member] = false;
        std::sort(group.begin(), group.end());
        if (group.size() > 1) _groups.push_back(std::move(group));
    }

    const NextNodes& _getNext;
    std::vector<std::uint32_t> _numbers;
    std::vector<std::uint32_t> _lowest;
    std::vector<bool> _isOpen;
    std::vector<std::uint32_t> _open;
    std::vector<std::pair<std::uint32_t, std::size_t>> _path;
    std::vector<std::vector<std::uint32_t>> _groups;
    std::uint32_t _numSeen = 0;
};

} // namespace

std::vector<std::vector<std::uint32_t>> findStronglyConnected(std::size_t numNodes, const NextNodes& getNext)
{
    return TarjanSearch(numNodes, getNext).take();
}

} // namespace osgLego
