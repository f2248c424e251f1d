#include "ArrowPlacement.h"

#include "ArrowShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/trigonometric.hpp>

namespace osgLego
{

namespace
{

/** A way to draw an arrow, and how bad it is. */
struct ArrowCandidate
{
    BookletArrow arrow;
    ArrowShape shape;
    double cost;
};

/** Finds the best arrows of one width. */
class ArrowSearch
{
public:
    ArrowSearch(std::span<const ArrowTarget> targets, double width, const BookletFrame& area,
                std::span<const BookletFrame> shown);

    /** Choose arrows that do not touch each other. @return false if none were found. */
    bool run();

    const ArrowCandidate& getChoice(std::size_t target) const { return _candidates[target][_choices[target]]; }

private:
    void addCandidates(const ArrowTarget& target);
    double rate(const BookletArrow& arrow, const ArrowShape& shape) const;
    double findCovered(const BookletArrow& arrow, const ArrowShape& shape) const;
    bool isFree(std::size_t target, std::size_t candidate) const;
    bool place(std::size_t numPlaced);
    void improve();

    static constexpr std::size_t UNPLACED = std::numeric_limits<std::size_t>::max();

    double _width;
    const BookletFrame& _area;
    std::span<const BookletFrame> _shown;
    std::vector<std::vector<ArrowCandidate>> _candidates; // of each target, the best one first
    std::vector<std::size_t> _choices;
    std::vector<std::size_t> _order; // of targets, from top to bottom
    int _numTries = 0;
};

ArrowSearch::ArrowSearch(std::span<const ArrowTarget> targets, double width, const BookletFrame& area,
                         std::span<const BookletFrame> shown) :
    _width(width),
    _area(area), _shown(shown), _choices(targets.size(), UNPLACED), _order(targets.size())
{
    for (const ArrowTarget& target : targets)
        addCandidates(target);
    std::iota(_order.begin(), _order.end(), std::size_t{0});
    std::stable_sort(_order.begin(), _order.end(),
                     [&](std::size_t a, std::size_t b) { return targets[a].tip.y > targets[b].tip.y; });
}

void ArrowSearch::addCandidates(const ArrowTarget& target)
{
    // Steep and of the usual length at first; in widths of the shaft.
    constexpr std::array ANGLES{0.0, -15.0, 15.0, -30.0, 30.0, -45.0, 45.0, -60.0, 60.0, -75.0, 75.0};
    constexpr std::array LENGTHS{6.5, 5.0, 8.5, 11.0, 14.0, 18.0, 24.0};
    constexpr double COST_OF_ANGLE = 1.0 / 45.0; // a degree
    constexpr double COST_OF_LENGTH = 0.2;       // a width
    std::vector<ArrowCandidate>& candidates = _candidates.emplace_back();
    for (const double angle : ANGLES)
        for (const double length : LENGTHS)
        {
            BookletArrow arrow;
            arrow.tip = target.tip;
            arrow.width = _width;
            const double radians = glm::radians(angle);
            arrow.tail = arrow.tip + glm::dvec2(std::sin(radians), std::cos(radians)) * (length * _width);
            arrow.letter = ArrowShape::findLetter(arrow);
            const ArrowShape shape(arrow, target.numCharacters);
            const double cost = COST_OF_ANGLE * std::abs(angle) + COST_OF_LENGTH * std::abs(length - LENGTHS.front()) +
                                rate(arrow, shape);
            candidates.push_back({arrow, shape, cost});
        }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const ArrowCandidate& own, const ArrowCandidate& other) { return own.cost < other.cost; });
}

/** How bad an arrow is for itself, apart from its direction and length. */
double ArrowSearch::rate(const BookletArrow& arrow, const ArrowShape& shape) const
{
    // For each width of a shaft. Wider pictures have a smaller scale; higher ones only need more paper.
    constexpr double COST_BESIDE = 1.0;
    constexpr double COST_ABOVE = 0.05;
    const BookletFrame& frame = shape.getFrame();
    const double beside = std::max({0.0, _area.lowest.x - frame.lowest.x, frame.highest.x - _area.highest.x});
    const double above = std::max(0.0, frame.highest.y - _area.highest.y);
    return (COST_BESIDE * beside + COST_ABOVE * above) / _width + findCovered(arrow, shape);
}

/** How much an arrow covers of the parts that the picture shows. */
double ArrowSearch::findCovered(const BookletArrow& arrow, const ArrowShape& shape) const
{
    constexpr double COST_OF_LETTER = 3.0; // if all of it covers parts
    constexpr double COST_OF_SHAFT = 1.0;  // likewise
    constexpr int SAMPLES = 6;
    double letter = 0.0;
    std::array<bool, SAMPLES> covers{};
    for (const BookletFrame& part : _shown)
    {
        if (const auto& own = shape.getLetter())
        {
            const glm::dvec2 common = glm::min(part.highest, own->highest) - glm::max(part.lowest, own->lowest);
            if (common.x > 0.0 && common.y > 0.0) letter += common.x * common.y / (own->getSize().x * own->getSize().y);
        }
        for (int sample = 0; sample < SAMPLES; ++sample)
        {
            const glm::dvec2 place = glm::mix(arrow.tail, arrow.tip, (sample + 0.5) / SAMPLES);
            covers[static_cast<std::size_t>(sample)] |= place.x > part.lowest.x && place.x < part.highest.x &&
                                                        place.y > part.lowest.y && place.y < part.highest.y;
        }
    }
    const auto shaft = static_cast<double>(std::count(covers.begin(), covers.end(), true)) / SAMPLES;
    return COST_OF_LETTER * std::min(letter, 1.0) + COST_OF_SHAFT * shaft;
}

/** Whether an arrow touches none of the others that are placed. */
bool ArrowSearch::isFree(std::size_t target, std::size_t candidate) const
{
    const ArrowShape& shape = _candidates[target][candidate].shape;
    for (std::size_t other = 0; other < _choices.size(); ++other)
        if (other != target && _choices[other] != UNPLACED && shape.touches(getChoice(other).shape)) return false;
    return true;
}

bool ArrowSearch::run()
{
    if (place(0))
    {
        improve();
        return true;
    }
    for (std::size_t& choice : _choices)
        choice = choice == UNPLACED ? 0 : choice;
    return false;
}

/** Place the arrows that are not placed yet, those that cost least at first. */
bool ArrowSearch::place(std::size_t numPlaced)
{
    constexpr int MOST_TRIES = 20000;
    if (numPlaced == _order.size()) return true;
    const std::size_t target = _order[numPlaced];
    for (std::size_t candidate = 0; candidate < _candidates[target].size(); ++candidate)
    {
        if (++_numTries > MOST_TRIES) return false;
        if (!isFree(target, candidate)) continue;
        _choices[target] = candidate;
        if (place(numPlaced + 1)) return true;
        _choices[target] = UNPLACED;
    }
    return false;
}

/** Move each arrow to the best place that the others leave, until none is better. */
void ArrowSearch::improve()
{
    for (bool isBetter = true; isBetter;)
    {
        isBetter = false;
        for (std::size_t target = 0; target < _choices.size(); ++target)
            for (std::size_t candidate = 0; candidate < _choices[target]; ++candidate)
                if (isFree(target, candidate))
                {
                    _choices[target] = candidate;
                    isBetter = true;
                }
    }
}

} // namespace

ArrowPlacement::ArrowPlacement(std::span<const ArrowTarget> targets, double width, const BookletFrame& area,
                               std::span<const BookletFrame> shown)
{
    constexpr double THINNER = 0.8;
    constexpr double LEAST_SHARE = 0.2; // of the width
    if (targets.empty()) return;
    for (double share = 1.0; _arrows.empty(); share *= THINNER)
    {
        ArrowSearch search(targets, share * width, area, shown);
        if (!search.run() && share > LEAST_SHARE) continue;
        for (std::size_t target = 0; target < targets.size(); ++target)
        {
            const ArrowCandidate& choice = search.getChoice(target);
            _arrows.push_back(choice.arrow);
            const BookletFrame& frame = choice.shape.getFrame();
            _frame = _frame ? _frame->unite(frame) : frame;
        }
    }
}

} // namespace osgLego
