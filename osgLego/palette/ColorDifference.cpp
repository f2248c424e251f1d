#include <osgLego/palette/ColorDifference.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

namespace osgLego
{

namespace
{

/** The share of a mean chroma beyond which the formula treats colours as chromatic, 0 to 1. */
double chromaticShare(double chroma)
{
    const double third = chroma * chroma * chroma;
    const double seventh = third * third * chroma;
    return std::sqrt(seventh / (seventh + 6103515625.0)); // 25^7
}

/** By how much the formula increases a, for a mean chroma: greys are more sensitive to red and green. */
double rednessOf(double chroma)
{
    return 1.5 - 0.5 * chromaticShare(chroma);
}

/** Two colours in a plane of equal lightness, and the hue between them. Hues are unit vectors instead of angles, which
 * avoids trigonometric functions. */
class HuePair
{
public:
    HuePair(const glm::dvec2& color, const glm::dvec2& other) :
        _color(color), _other(other), _chroma(glm::length(color)), _otherChroma(glm::length(other)),
        _product(_chroma * _otherChroma), _cosine(glm::dot(color, other)), _sine(color.x * other.y - color.y * other.x)
    {
    }

    double getMeanChroma() const { return 0.5 * (_chroma + _otherChroma); }
    double getChromaDifference() const { return _otherChroma - _chroma; }

    /** The difference in hue as a length, positive if the hue of the other colour is larger. */
    double getHueDifference() const
    {
        // Each form loses digits where the other one is used.
        if (_cosine > 0.0) return _sine / std::sqrt(0.5 * (_product + _cosine));
        const double length = std::sqrt(2.0 * (_product - _cosine));
        return isOtherLarger() ? length : -length;
    }

    /** The mean hue; that of the chromatic colour if the other one has none. */
    glm::dvec2 getMeanHue() const
    {
        if (_product == 0.0) return _chroma + _otherChroma > 0.0 ? (_color + _other) / (_chroma + _otherChroma) : RED;
        const glm::dvec2 hue = _color / _chroma;
        const glm::dvec2 otherHue = _other / _otherChroma;
        if (_cosine > 0.0) return glm::normalize(hue + otherHue);
        const glm::dvec2 chord = glm::normalize(hue - otherHue);
        return isOtherLarger() ? glm::dvec2(-chord.y, chord.x) : glm::dvec2(chord.y, -chord.x);
    }

private:
    static constexpr glm::dvec2 RED{1.0, 0.0}; // the hue 0

    /** Whether the shorter arc from the first hue to the other one goes counterclockwise; of two equal arcs, the one
     * that doesn't cross the hue 0 counts. */
    bool isOtherLarger() const
    {
        const bool isInUpperHalf = _color.y > 0.0 || (_color.y == 0.0 && _color.x > 0.0);
        return _sine > 0.0 || (_sine == 0.0 && isInUpperHalf);
    }

    glm::dvec2 _color;
    glm::dvec2 _other;
    double _chroma;
    double _otherChroma;
    double _product; // of the chromas
    double _cosine;  // times the product
    double _sine;    // times the product
};

/** The formula's T: how much less or more differences of hue count at a hue. */
double hueWeight(const glm::dvec2& hue)
{
    const double cos1 = hue.x;
    const double sin1 = hue.y;
    const double cos2 = cos1 * cos1 - sin1 * sin1;
    const double sin2 = 2.0 * sin1 * cos1;
    const double cos3 = cos2 * cos1 - sin2 * sin1;
    const double sin3 = sin2 * cos1 + cos2 * sin1;
    const double cos4 = cos2 * cos2 - sin2 * sin2;
    const double sin4 = 2.0 * sin2 * cos2;
    constexpr double COS_30 = 0.8660254037844387;
    constexpr double SIN_30 = 0.5;
    constexpr double COS_6 = 0.9945218953682733;
    constexpr double SIN_6 = 0.1045284632676535;
    constexpr double COS_63 = 0.4539904997395468;
    constexpr double SIN_63 = 0.8910065241883678;
    return 1.0 - 0.17 * (cos1 * COS_30 + sin1 * SIN_30) + 0.24 * cos2 + 0.32 * (cos3 * COS_6 - sin3 * SIN_6) -
           0.20 * (cos4 * COS_63 + sin4 * SIN_63);
}

/** The formula's R_T: how chroma and hue interact in blue. */
double rotation(const glm::dvec2& hue, double chroma)
{
    constexpr double COS_275 = 0.0871557427476582;
    constexpr double SIN_275 = -0.9961946980917455;
    const glm::dvec2 fromBlue(hue.x * COS_275 + hue.y * SIN_275, hue.y * COS_275 - hue.x * SIN_275);
    // More than 120 degrees away, the angle below is less than 1e-8 degrees. The formula counts degrees from hue 0, so
    // that those just above it are far from 275.
    const bool isInFirstQuadrant = hue.x > 0.0 && hue.y >= 0.0;
    if (isInFirstQuadrant || fromBlue.x < -0.5) return 0.0;
    const double distance = glm::degrees(std::atan2(fromBlue.y, fromBlue.x)) / 25.0;
    return -2.0 * chromaticShare(chroma) * std::sin(glm::radians(60.0 * std::exp(-distance * distance)));
}

double lightnessWeight(double color, double other)
{
    const double fromMiddle = 0.5 * (color + other) - 50.0;
    const double square = fromMiddle * fromMiddle;
    return 1.0 + 0.015 * square / std::sqrt(20.0 + square);
}

} // namespace

double lightnessDifference(const glm::dvec3& color, const glm::dvec3& other)
{
    return std::abs(color.x - other.x) / lightnessWeight(color.x, other.x);
}

glm::dmat3 ciede2000Scale(const glm::dvec3& color)
{
    const double redness = rednessOf(glm::length(glm::dvec2(color.y, color.z)));
    const glm::dvec2 place(redness * color.y, color.z);
    const double chroma = glm::length(place);
    const glm::dvec2 hue = chroma > 0.0 ? place / chroma : glm::dvec2(1.0, 0.0);
    const double chromaScale = 1.0 / (1.0 + 0.045 * chroma);
    const double hueScale = 1.0 / (1.0 + 0.015 * chroma * hueWeight(hue));
    return {glm::dvec3(1.0 / lightnessWeight(color.x, color.x), 0.0, 0.0),
            redness * glm::dvec3(0.0, hue.x * chromaScale, -hue.y * hueScale),
            glm::dvec3(0.0, hue.y * chromaScale, hue.x * hueScale)};
}

double ciede2000(const glm::dvec3& color, const glm::dvec3& other)
{
    const double meanChroma =
        0.5 * (glm::length(glm::dvec2(color.y, color.z)) + glm::length(glm::dvec2(other.y, other.z)));
    const double redness = rednessOf(meanChroma);
    const HuePair pair({redness * color.y, color.z}, {redness * other.y, other.z});
    const double chroma = pair.getMeanChroma();
    const glm::dvec2 hue = pair.getMeanHue();
    const double lightnessTerm = lightnessDifference(color, other);
    const double chromaTerm = pair.getChromaDifference() / (1.0 + 0.045 * chroma);
    const double hueTerm = pair.getHueDifference() / (1.0 + 0.015 * chroma * hueWeight(hue));
    return std::sqrt(lightnessTerm * lightnessTerm + chromaTerm * chromaTerm + hueTerm * hueTerm +
                     rotation(hue, chroma) * chromaTerm * hueTerm);
}

} // namespace osgLego
