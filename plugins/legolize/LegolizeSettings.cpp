#include "LegolizeSettings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace
{

using Occlusion = LegolizeSettings::Occlusion;
using Item = std::pair<std::string, std::string>;

constexpr std::array<std::pair<std::string_view, Occlusion>, 4> OCCLUSION_NAMES{
    {{"off", Occlusion::OFF}, {"low", Occlusion::LOW}, {"medium", Occlusion::MEDIUM}, {"high", Occlusion::HIGH}}};

std::string trimmed(const std::string& text)
{
    constexpr const char* SPACE = " \t\r\n";
    const auto begin = text.find_first_not_of(SPACE);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(SPACE) - begin + 1);
}

bool isOwnKey(const std::string& key)
{
    return key == "occlusion" || key == "distant" || key == "probe";
}

/** Take apart a list into the pairs whose keys are the loader's own, and a list of all other items, if there are any.
 */
std::vector<Item> takeOwnItems(const std::string& text, std::optional<std::string>& others)
{
    std::vector<Item> own;
    for (std::string::size_type begin = 0; begin <= text.size();)
    {
        const auto end = std::min(text.find(',', begin), text.size());
        const std::string item = text.substr(begin, end - begin);
        const auto equals = item.find('=');
        const std::string key = equals == std::string::npos ? std::string() : trimmed(item.substr(0, equals));
        if (isOwnKey(key))
            own.emplace_back(key, trimmed(item.substr(equals + 1)));
        else
            others = others ? *others + "," + item : item;
        begin = end + 1;
    }
    return own;
}

bool readOcclusion(const std::string& value, Occlusion& occlusion)
{
    for (const auto& [name, known] : OCCLUSION_NAMES)
        if (name == value)
        {
            occlusion = known;
            return true;
        }
    return false;
}

/** Read one of the loader's own items. @return an error message, empty if there is no error. */
std::string readOwnItem(const Item& item, LegolizeSettings& settings)
{
    const auto& [key, value] = item;
    if (key == "occlusion" && !readOcclusion(value, settings.occlusion))
        return "bad value '" + value + "' for occlusion; expected off, low, medium or high";
    if (key == "distant" && value != "on" && value != "off")
        return "bad value '" + value + "' for distant; expected on or off";
    if (key == "distant") settings.distant = value == "on";
    if (key == "probe" && value.empty())
        return "no value for probe; expected the name of a high dynamic range picture, without commas";
    if (key == "probe") settings.probe = value;
    return {};
}

/** Read the loader's own items. @return an error message, empty if there is no error. */
std::string readOwnItems(const std::vector<Item>& items, LegolizeSettings& settings)
{
    for (std::size_t index = 0; index < items.size(); ++index)
    {
        for (std::size_t earlier = 0; earlier < index; ++earlier)
            if (items[earlier].first == items[index].first) return "'" + items[index].first + "' is given twice";
        std::string error = readOwnItem(items[index], settings);
        if (!error.empty()) return error;
    }
    return {};
}

} // namespace

std::optional<osgLego::AmbientOcclusionSettings> LegolizeSettings::getOcclusion() const
{
    using Quality = osgLego::AmbientOcclusionQuality;
    osgLego::AmbientOcclusionSettings result;
    result.distant = distant;
    switch (occlusion)
    {
    case Occlusion::BY_LOOK:
        if (lego.view.look == osgLego::Look::PLAIN) return std::nullopt;
        break;
    case Occlusion::OFF:
        return std::nullopt;
    case Occlusion::LOW:
        result.quality = Quality::LOW;
        break;
    case Occlusion::MEDIUM:
        result.quality = Quality::MEDIUM;
        break;
    case Occlusion::HIGH:
        result.quality = Quality::HIGH;
        break;
    }
    return result;
}

bool LegolizeSettings::parse(const std::string& text, LegolizeSettings& settings, std::string& error)
{
    LegolizeSettings wanted = settings;
    std::optional<std::string> others;
    const std::vector<Item> own = takeOwnItems(text, others);
    if (const std::string wrong = readOwnItems(own, wanted); !wrong.empty())
    {
        error = wrong;
        return false;
    }
    if (others && !osgLego::LegoSettings::parse(*others, wanted.lego, error))
    {
        // Such messages end with the keys of LegoSettings.
        if (error.find("the keys are") != std::string::npos) error += ", occlusion, distant, probe";
        return false;
    }
    settings = wanted;
    return true;
}

bool LegolizeSettings::isKey(const std::string& name)
{
    return isOwnKey(name) || osgLego::LegoSettings::isKey(name);
}
