#include <osgLego/design/DesignSettings.h>

#include <osgLego/design/DesignFailure.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace osgLego
{

namespace
{

constexpr double STUD_PITCH = 8.0; // millimetres
constexpr unsigned int FEW_COLORS = 8;

/** Settings of a model of parts whose others can be chosen. */
LegoSettings createFreeSettings()
{
    LegoSettings settings;
    settings.parts.set = PartSet::BRICKS;
    settings.parts.connect = true;
    settings.grid.proportions = Proportions::BRICK;
    return settings;
}

/** Replace the settings in a text. @return false, with a sentence in `error`, if they are bad. */
bool replace(const std::string& text, LegoSettings& settings, std::string& error)
{
    return text.empty() || LegoSettings::parse(text, settings, error);
}

} // namespace

DesignSettings::DesignSettings(const DesignOptions& options)
{
    LegoSettings unjoined = createFreeSettings();
    unjoined.parts.connect = false; // which needs parts
    std::string error;
    const bool isReadable = replace(options.settings, unjoined, error);
    if (isReadable && unjoined.parts.set == PartSet::NONE)
        throw DesignFailure("parts=none gives no parts; expected parts=bricks");
    _isConnectionGiven = isReadable && unjoined.parts.connect;
    const bool isSizeGiven = determineSize(options);
    if (isSizeGiven && options.length)
        throw DesignFailure("a length can't be combined with a resolution or a cell; expected either");
    _canChooseSize = !isSizeGiven && !options.length;
    listAll(options);
    _canJoin = _all.front().parts.connect;
}

/** Whether settings determine the size of cells, so that nothing of it can be chosen. */
bool DesignSettings::determineSize(const DesignOptions& options)
{
    const auto readWith = [&](unsigned int resolution)
    {
        LegoSettings settings = createFreeSettings();
        settings.grid.resolution = resolution;
        std::string error;
        if (!replace(options.settings, settings, error)) throw DesignFailure(error);
        return settings.grid;
    };
    return readWith(1) == readWith(2);
}

void DesignSettings::listAll(const DesignOptions& options)
{
    std::string error;
    for (const Proportions proportions : {Proportions::BRICK, Proportions::PLATE})
        for (const Fill fill : {Fill::SURFACE, Fill::SHELL, Fill::SOLID})
            for (const bool hasFewColors : {false, true})
            {
                LegoSettings settings = createFreeSettings();
                settings.grid.proportions = proportions;
                settings.parts.fill = fill;
                if (hasFewColors) settings.colors.count = FEW_COLORS;
                // Some settings that are kept exclude others, as that of no palette excludes few colours.
                const bool isPossible = replace(options.settings, settings, error);
                if (options.length)
                    settings.grid.resolution = static_cast<unsigned int>(std::lround(*options.length / STUD_PITCH));
                if (isPossible && std::find(_all.begin(), _all.end(), settings) == _all.end()) _all.push_back(settings);
            }
    if (_all.empty()) throw DesignFailure(error);
}

} // namespace osgLego
