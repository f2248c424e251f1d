#include <osgLego/palette/ColorChoice.h>

#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <glm/vec3.hpp>

namespace osgLego
{

namespace
{

/** Finds the best colours, called medoids here, for the colours of a surface, called points. */
class MedoidSearch
{
public:
    MedoidSearch(std::span<const PaletteColor> colors, const std::vector<ColorShare>& shares) :
        _numColors(colors.size()), _numPoints(shares.size()), _errors(_numColors * _numPoints), _isMedoid(_numColors),
        _points(_numPoints)
    {
        std::vector<glm::dvec3> places;
        places.reserve(shares.size());
        for (const ColorShare& share : shares)
            places.push_back(toMatchingLab(share.color));
        for (std::size_t color = 0; color < _numColors; ++color)
        {
            const glm::dvec3 place = toMatchingLab(colors[color].color);
            for (std::size_t point = 0; point < _numPoints; ++point)
            {
                const double difference = ciede2000(places[point], place);
                _errors[color * _numPoints + point] = shares[point].weight * difference * difference;
            }
        }
    }

    /** @return the indices of the medoids, in ascending order. */
    std::vector<std::size_t> find(std::size_t count)
    {
        while (_medoids.size() < count)
            add();
        while (exchange())
            findNearest();
        std::sort(_medoids.begin(), _medoids.end());
        return _medoids;
    }

private:
    /** A colour of the surface, and its weighted errors. */
    struct Point
    {
        std::size_t medoid = 0; // the place of the nearest in _medoids
        double nearest = std::numeric_limits<double>::max();
        double second = std::numeric_limits<double>::max(); // to the second nearest
    };

    const double* errorsOf(std::size_t color) const { return _errors.data() + color * _numPoints; }

    /** Add the colour that leaves the least error. */
    void add()
    {
        std::size_t best = _numColors;
        double leastError = 0.0;
        for (std::size_t color = 0; color < _numColors; ++color)
        {
            if (_isMedoid[color]) continue;
            const double* errors = errorsOf(color);
            double error = 0.0;
            for (std::size_t point = 0; point < _numPoints; ++point)
                error += std::min(_points[point].nearest, errors[point]);
            if (best < _numColors && error >= leastError) continue;
            best = color;
            leastError = error;
        }
        _isMedoid[best] = true;
        _medoids.push_back(best);
        findNearest();
    }

    void findNearest()
    {
        std::fill(_points.begin(), _points.end(), Point());
        for (std::size_t medoid = 0; medoid < _medoids.size(); ++medoid)
        {
            const double* errors = errorsOf(_medoids[medoid]);
            for (std::size_t point = 0; point < _numPoints; ++point)
            {
                Point& nearest = _points[point];
                if (errors[point] < nearest.nearest)
                    nearest = {medoid, errors[point], nearest.nearest};
                else
                    nearest.second = std::min(nearest.second, errors[point]);
            }
        }
    }

    /** For each medoid, the change of the error if a colour replaces it. */
    std::vector<double> changesBy(std::size_t color) const
    {
        const double* errors = errorsOf(color);
        std::vector<double> changes(_medoids.size());
        double changeOfAll = 0.0; // by the points that go to the new colour, whichever medoid leaves
        for (std::size_t index = 0; index < _numPoints; ++index)
        {
            const Point& point = _points[index];
            const double gain = std::min(errors[index] - point.nearest, 0.0);
            changeOfAll += gain;
            changes[point.medoid] += std::min(errors[index], point.second) - point.nearest - gain;
        }
        for (double& change : changes)
            change += changeOfAll;
        return changes;
    }

    /** Exchange a medoid for another colour, the pair that helps most. @return false if none does. */
    bool exchange()
    {
        double error = 0.0;
        for (const Point& point : _points)
            error += point.nearest;
        // Rounding must not make two exchanges take turns.
        double bestChange = -1e-9 * error;
        std::size_t bestMedoid = _medoids.size();
        std::size_t bestColor = 0;
        for (std::size_t color = 0; color < _numColors; ++color)
        {
            if (_isMedoid[color]) continue;
            const std::vector<double> changes = changesBy(color);
            const auto least = std::min_element(changes.begin(), changes.end());
            if (*least >= bestChange) continue;
            bestChange = *least;
            bestMedoid = static_cast<std::size_t>(least - changes.begin());
            bestColor = color;
        }
        if (bestMedoid == _medoids.size()) return false;
        _isMedoid[_medoids[bestMedoid]] = false;
        _isMedoid[bestColor] = true;
        _medoids[bestMedoid] = bestColor;
        return true;
    }

    std::size_t _numColors;
    std::size_t _numPoints;
    std::vector<double> _errors; // for each colour, the weighted squared difference of each point
    std::vector<bool> _isMedoid; // for each colour
    std::vector<Point> _points;
    std::vector<std::size_t> _medoids;
};

} // namespace

osg::ref_ptr<const Palette> chooseColors(const Palette& palette, const ColorHistogram& histogram, std::size_t count)
{
    const std::span<const PaletteColor> colors = palette.getColors();
    if (count >= colors.size()) return &palette;
    std::vector<PaletteColor> chosen;
    for (const std::size_t color : MedoidSearch(colors, histogram.getShares()).find(count))
        chosen.push_back(colors[color]);
    std::string ignored; // there are at least one and fewer than before
    return Palette::create(std::move(chosen), ignored);
}

} // namespace osgLego
