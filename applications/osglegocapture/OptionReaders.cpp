#include "OptionReaders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include <osgDB/FileNameUtils>
#include <osgLego/ModelDesigner.h>

namespace osgLego
{

namespace
{

constexpr int MAXIMUM_SIZE = 8192;

std::string badValue(const char* option, const std::string& text, const char* expected)
{
    return std::string("bad value '") + text + "' for " + option + "; expected " + expected;
}

} // namespace

std::string readSize(const std::string& text, CaptureOptions& options)
{
    int width = 0;
    int height = 0;
    char rest = 0;
    // Numbers of more digits would overflow; they are too large, or their rest is not read.
    const bool isRead = std::sscanf(text.c_str(), "%9dx%9d%c", &width, &height, &rest) == 2;
    if (!isRead || width < 1 || height < 1 || width > MAXIMUM_SIZE || height > MAXIMUM_SIZE)
        return badValue("--size", text, "WIDTHxHEIGHT in pixels, each 1 to 8192");
    options.width = width;
    options.height = height;
    options.isSizeGiven = true;
    return {};
}

std::string readView(const std::string& text, CaptureOptions& options)
{
    CaptureView read;
    char rest = 0;
    const int count = std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &read.azimuth, &read.elevation, &read.distance, &rest);
    constexpr double MOST_AZIMUTH = 360000.0; // a thousand turns: sines of huge angles are meaningless
    const bool isInRange =
        std::abs(read.azimuth) <= MOST_AZIMUTH && std::isfinite(read.elevation) && std::isfinite(read.distance);
    const bool isWhole = count == 3 || (count == 2 && text.find_last_of(',') == text.find(','));
    if (!isWhole || !isInRange || std::abs(read.elevation) > 90.0 || (count == 3 && !(read.distance > 0.0)))
        return badValue("--view", text,
                        "AZIMUTH,ELEVATION[,DISTANCE]: degrees up to 360000, degrees from -90 to 90, and radii of the "
                        "mesh above 0");
    options.view = read;
    options.isViewGiven = true;
    return {};
}

std::string readLength(const std::string& text, CaptureOptions& options)
{
    static const std::map<std::string, double, std::less<>> UNITS{
        {"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};
    double number = 0.0;
    int length = 0;
    const bool isRead = std::sscanf(text.c_str(), "%lf%n", &number, &length) == 1;
    std::string name =
        osgDB::convertToLowerCase(isRead ? text.substr(static_cast<std::size_t>(length)) : std::string());
    name.erase(0, name.find_first_not_of(' '));
    const auto unit = UNITS.find(name);
    const double millimeters = unit == UNITS.end() ? 0.0 : number * unit->second;
    // Written so that NaN is rejected.
    if (!(millimeters >= DesignOptions::SHORTEST && millimeters <= DesignOptions::LONGEST))
        return badValue("--length", text, "a number with mm, cm, m or in, from 8mm to 8.192m, for example 20cm");
    options.buildLength = millimeters;
    return {};
}

std::string readParts(const std::string& text, CaptureOptions& options)
{
    constexpr std::size_t MOST_DIGITS = 5;
    const bool isNumber =
        !text.empty() && text.size() <= MOST_DIGITS && text.find_first_not_of("0123456789") == std::string::npos;
    const std::size_t number = isNumber ? std::stoul(text) : 0;
    if (number < 1 || number > DesignOptions::MOST_PARTS) return badValue("--parts", text, "1 to 10000 parts");
    options.buildParts = number;
    return {};
}

std::string findKeyOfOption(std::string_view settings)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 3> OPTIONS{
        {{"occlusion", "--occlusion off"}, {"distant", "--occlusion grid,distant=off"}, {"probe", "--probe park.exr"}}};
    for (std::size_t begin = 0; begin < settings.size();)
    {
        const std::size_t end = std::min(settings.find(',', begin), settings.size());
        const std::string_view item = settings.substr(begin, end - begin);
        const std::size_t first = std::min(item.find_first_not_of(' '), item.size());
        const std::string_view key = item.substr(first, item.find_first_of(" =", first) - first);
        for (const auto& [name, option] : OPTIONS)
            if (key == name)
                return "'" + std::string(key) +
                       "' is a key of names with .legolize only; expected an option, such as " + option;
        begin = end + 1;
    }
    return {};
}

std::string readOcclusion(const std::string& text, CaptureOptions& options)
{
    if (text.empty()) return badValue("--occlusion", text, "off, grid, screen or both, then settings");
    options.isOcclusionGiven = true;
    static const std::map<std::string, BrickOcclusion, std::less<>> KINDS{{"off", BrickOcclusion::OFF},
                                                                          {"grid", BrickOcclusion::GRID},
                                                                          {"screen", BrickOcclusion::SCREEN},
                                                                          {"both", BrickOcclusion::BOTH}};
    const std::size_t comma = text.find(',');
    const auto kind = KINDS.find(text.substr(0, comma));
    options.brickOcclusion = kind == KINDS.end() ? BrickOcclusion::SCREEN : kind->second;
    const std::string settings = kind == KINDS.end()          ? text
                                 : comma == std::string::npos ? std::string()
                                                              : text.substr(comma + 1);
    std::string error;
    if (!settings.empty() && !AmbientOcclusionSettings::parse(settings, options.occlusion, error))
        return "--occlusion: " + error + " (or off, grid, screen or both first)";
    options.hasOcclusion = options.brickOcclusion == BrickOcclusion::SCREEN ||
                           options.brickOcclusion == BrickOcclusion::BOTH ||
                           options.occlusion.output != AmbientOcclusionOutput::PICTURE;
    return {};
}

std::string readNumber(const char* option, const std::string& text, const NumberRange& range, double& number)
{
    char rest = 0;
    double read = 0.0;
    const bool isRead = std::sscanf(text.c_str(), "%lf%c", &read, &rest) == 1;
    // Written so that NaN is rejected.
    if (!isRead || !(read >= range.minimum && read <= range.maximum)) return badValue(option, text, range.text);
    number = read;
    return {};
}

std::string readSteps(const std::string& text, CaptureOptions& options)
{
    unsigned long first = 0;
    unsigned long last = 0;
    char rest = 0;
    const bool isRead = text.find_first_not_of("0123456789-") == std::string::npos &&
                        text.find('-') == text.rfind('-') &&
                        std::sscanf(text.c_str(), "%9lu-%9lu%c", &first, &last, &rest) == 2;
    if (!isRead || first < 1 || last < first)
        return badValue("--steps", text, "FIRST-LAST, such as 1-50, with FIRST from 1 to LAST");
    options.bookletSteps = {first, last};
    return {};
}

std::string readContext(const std::string& text, ContextKind& kind)
{
    static const std::map<std::string, ContextKind> kinds{
        {"auto", ContextKind::AUTO}, {"egl", ContextKind::EGL}, {"osmesa", ContextKind::OSMESA}};
    const auto found = kinds.find(text);
    if (found == kinds.end()) return badValue("--context", text, "auto, egl or osmesa");
    kind = found->second;
    return {};
}

std::string readBase(const std::string& text, CaptureOptions& options)
{
    if (text != "table" && text != "plate") return badValue("--base", text, "table or plate");
    options.base = text == "table" ? BuildingBase::TABLE : BuildingBase::PLATE;
    return {};
}

std::string readLoad(const std::string& text, CaptureOptions& options)
{
    constexpr double MOST_GRAMS = 1e6;
    CaptureLoad load;
    char unit = 0;
    char rest = 0;
    const int count = std::sscanf(text.c_str(), "%6d,%6d,%6d=%lf%c%c", &load.cell.x, &load.cell.y, &load.cell.z,
                                  &load.grams, &unit, &rest);
    // Written so that NaN is rejected.
    if (count != 5 || unit != 'g' || !(load.grams > 0.0 && load.grams <= MOST_GRAMS))
        return badValue("--load", text,
                        "X,Y,Z=GRAMSg: a cell of a part, and more than 0 to 1000000 grams, for example 3,0,7=200g");
    options.loads.push_back(load);
    return {};
}

} // namespace osgLego
