#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>

#include <optional>
#include <string>

/** The settings of `.legolize`: those of osgLego::LegoSettings, of ambient occlusion and of the light. describe() lists
 * the keys of their text form. */
struct LegolizeSettings
{
    enum class Occlusion
    {
        OFF,
        GRID,
        SCREEN,
        BOTH,
        LOW, // SCREEN with this quality
        MEDIUM,
        HIGH
    };

    osgLego::LegoSettings lego;
    std::optional<Occlusion> occlusion; //!< unset: GRID in the full look, OFF in the plain one
    bool distant = true;                //!< whether distant bricks occlude
    std::optional<std::string> probe;   //!< the file name of a picture; unset: the built-in sky

    /** The settings of the AmbientOcclusionScene; unset: none. */
    std::optional<osgLego::AmbientOcclusionSettings> getScene() const;
    /** The occlusion of the bricks. */
    osgLego::BrickOcclusion getOcclusion() const;

    /** Read `key=value` separated by commas. Settings whose keys are not given keep their values.
     * @return false, with one sentence in `error` and `settings` unchanged, if there is an error. */
    static bool parse(const std::string& text, LegolizeSettings& settings, std::string& error);

    /** All keys: those of osgLego::LegoSettings, and then the others. */
    static const osgLego::SettingDescriptions& describe();
};
