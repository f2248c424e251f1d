#include <osgLego/LegoSettings.h>

#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace osgLego
{

namespace
{

template <typename Value>
struct Name
{
    std::string_view text;
    Value value;
};

constexpr std::array PROPORTIONS_NAMES{Name<Proportions>{"cube", Proportions::CUBE},
                                       Name<Proportions>{"brick", Proportions::BRICK},
                                       Name<Proportions>{"plate", Proportions::PLATE}};
constexpr std::array UP_NAMES{Name<UpAxis>{"y", UpAxis::Y}, Name<UpAxis>{"z", UpAxis::Z}};
constexpr std::array METHOD_NAMES{Name<VoxelizationMethod>{"points", VoxelizationMethod::POINTS},
                                  Name<VoxelizationMethod>{"exact", VoxelizationMethod::EXACT}};
constexpr std::array TARGET_NAMES{Name<VoxelizationTarget>{"projected", VoxelizationTarget::PROJECTED},
                                  Name<VoxelizationTarget>{"addressed", VoxelizationTarget::ADDRESSED}};
constexpr std::string_view KEYS = "resolution, proportions, up, method, target, fbo, edge";

template <typename Value, std::size_t COUNT>
std::string_view nameOf(const std::array<Name<Value>, COUNT>& names, Value value)
{
    for (const auto& name : names)
        if (name.value == value) return name.text;
    return {};
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view SPACE = " \t\r\n";
    const auto begin = text.find_first_not_of(SPACE);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(SPACE) - begin + 1);
}

template <typename Number>
std::string toText(Number number)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), result.ptr};
}

template <typename Number>
bool toNumber(std::string_view text, Number& number)
{
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    return code == std::errc() && end == text.data() + text.size();
}

/** Reads one `key=value` after the other into a copy of the settings, and stops at the first mistake. */
class SettingsReader
{
public:
    explicit SettingsReader(const LegoSettings& settings) : _settings(settings) {}

    bool read(std::string_view text)
    {
        while (true)
        {
            const auto comma = text.find(',');
            if (!readItem(trimmed(text.substr(0, comma)))) return false;
            if (comma == std::string_view::npos) break;
            text.remove_prefix(comma + 1);
        }
        _error = _settings.check();
        return _error.empty();
    }

    const LegoSettings& getSettings() const { return _settings; }
    const std::string& getError() const { return _error; }

private:
    bool readItem(std::string_view item)
    {
        const auto equals = item.find('=');
        if (equals == std::string_view::npos)
        {
            if (item.empty() || item.find_first_not_of("0123456789") != std::string_view::npos)
                return fail("'" + std::string(item) + "' is neither a resolution (1 to " +
                            toText(LegoSettings::MAXIMUM_RESOLUTION) + ") nor key=value; the keys are " +
                            std::string(KEYS));
            return readValue("resolution", item);
        }
        return readValue(trimmed(item.substr(0, equals)), trimmed(item.substr(equals + 1)));
    }

    bool readValue(std::string_view key, std::string_view value)
    {
        if (!_seen.emplace(key).second) return fail("'" + std::string(key) + "' is given twice");
        if (key == "resolution") return readNumber(key, value, "a whole number, 1 to 1024", _settings.resolution);
        if (key == "proportions") return readName(key, value, PROPORTIONS_NAMES, _settings.proportions);
        if (key == "up") return readName(key, value, UP_NAMES, _settings.upAxis);
        if (key == "method") return readName(key, value, METHOD_NAMES, _settings.method);
        if (key == "target") return readName(key, value, TARGET_NAMES, _settings.target.emplace());
        if (key == "fbo") return readNumber(key, value, "a whole number of pixels, 16 to 8192", _settings.fboSize);
        if (key == "edge")
            return readNumber(key, value, "a number of cells, 0.0625 to 4", _settings.edgeLimit.emplace());
        return fail("unknown key '" + std::string(key) + "'; the keys are " + std::string(KEYS));
    }

    template <typename Number>
    bool readNumber(std::string_view key, std::string_view text, std::string_view allowed, Number& number)
    {
        if (toNumber(text, number)) return true;
        return failValue(key, text, allowed);
    }

    template <typename Value, std::size_t COUNT>
    bool readName(std::string_view key, std::string_view text, const std::array<Name<Value>, COUNT>& names,
                  Value& value)
    {
        std::string allowed;
        for (const auto& name : names)
        {
            if (name.text == text)
            {
                value = name.value;
                return true;
            }
            allowed += (allowed.empty() ? "" : ", ") + std::string(name.text);
        }
        return failValue(key, text, allowed);
    }

    bool failValue(std::string_view key, std::string_view text, std::string_view allowed)
    {
        return fail("bad value '" + std::string(text) + "' for " + std::string(key) +
                    "; allowed: " + std::string(allowed));
    }

    bool fail(const std::string& error)
    {
        _error = error;
        return false;
    }

    LegoSettings _settings;
    std::set<std::string, std::less<>> _seen;
    std::string _error;
};

template <typename Number>
std::string rangeError(const char* key, Number value, const char* unit, Number minimum, Number maximum)
{
    return "bad value '" + toText(value) + "' for " + key + "; allowed: " + unit + ", " + toText(minimum) + " to " +
           toText(maximum);
}

} // namespace

VoxelizationTarget LegoSettings::getTarget() const
{
    if (target) return *target;
    return method == VoxelizationMethod::POINTS ? VoxelizationTarget::PROJECTED : VoxelizationTarget::ADDRESSED;
}

double LegoSettings::getEdgeLimit() const
{
    if (edgeLimit) return *edgeLimit;
    return method == VoxelizationMethod::POINTS ? 1.0 : 2.0;
}

double LegoSettings::getCellHeight() const
{
    switch (proportions)
    {
    case Proportions::BRICK:
        return 1.2;
    case Proportions::PLATE:
        return 0.4;
    case Proportions::CUBE:
        break;
    }
    return 1.0;
}

std::string LegoSettings::check() const
{
    if (resolution < 1 || resolution > MAXIMUM_RESOLUTION)
        return rangeError("resolution", resolution, "a whole number", 1u, MAXIMUM_RESOLUTION);
    if (fboSize < MINIMUM_FBO_SIZE || fboSize > MAXIMUM_FBO_SIZE)
        return rangeError("fbo", fboSize, "a whole number of pixels", MINIMUM_FBO_SIZE, MAXIMUM_FBO_SIZE);
    const double edge = getEdgeLimit();
    if (!(edge >= MINIMUM_EDGE_LIMIT && edge <= MAXIMUM_EDGE_LIMIT))
        return rangeError("edge", edge, "a number of cells", MINIMUM_EDGE_LIMIT, MAXIMUM_EDGE_LIMIT);
    if (method == VoxelizationMethod::EXACT && getTarget() != VoxelizationTarget::ADDRESSED)
        return "bad value 'projected' for target; allowed with method=exact: addressed";
    return {};
}

bool LegoSettings::parse(const std::string& text, LegoSettings& settings, std::string& error)
{
    SettingsReader reader(settings);
    if (!reader.read(text))
    {
        error = reader.getError();
        return false;
    }
    settings = reader.getSettings();
    return true;
}

std::string LegoSettings::toString() const
{
    const LegoSettings defaults;
    std::ostringstream text;
    text << resolution;
    if (proportions != defaults.proportions) text << ",proportions=" << nameOf(PROPORTIONS_NAMES, proportions);
    if (upAxis != defaults.upAxis) text << ",up=" << nameOf(UP_NAMES, upAxis);
    if (method != defaults.method) text << ",method=" << nameOf(METHOD_NAMES, method);
    if (target) text << ",target=" << nameOf(TARGET_NAMES, *target);
    if (fboSize != defaults.fboSize) text << ",fbo=" << fboSize;
    if (edgeLimit) text << ",edge=" << toText(*edgeLimit);
    return text.str();
}

} // namespace osgLego
