#include "Harness.h"

#include <common/LegolizeName.h>
#include <legolize/LegolizeOptions.h>
#include <legolize/LegolizeSettings.h>
#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LegoSettings.h>

// Settings as text: those of nodes and files, the names of `.legolize`, and options of readers.

namespace
{

using osgLego::fuzz::require;

/** Settings that are read are valid, and the same after they are written and read again; others give a reason. */
template <typename Settings>
void checkSettings(const std::string& text)
{
    Settings settings;
    std::string error;
    if (!Settings::parse(text, settings, error))
    {
        require(!error.empty(), "a refusal of settings has a reason");
        require(settings == Settings(), "refused settings change nothing");
        return;
    }
    require(settings.check().empty(), "settings that were read are valid");
    Settings again;
    require(Settings::parse(settings.toString(), again, error), "settings that were written can be read: " + error);
    require(again == settings, "settings are the same after writing and reading: " + settings.toString());
}

void checkLegolizeSettings(const std::string& text)
{
    LegolizeSettings settings;
    std::string error;
    const bool isRead = LegolizeSettings::parse(text, settings, error);
    require(isRead == error.empty(), "settings are read, or there is a reason");
    require(settings.lego.check().empty(), "settings of .legolize are valid");
    settings.getScene();
    settings.getOcclusion();
}

void checkName(const std::string& name)
{
    osgLego::LegolizeName parsed;
    osgLego::LegolizeName::findLoneBracket(name);
    if (!osgLego::LegolizeName::parse(name, parsed)) return;
    require(!parsed.fileName.empty(), "a name before .legolize is not empty");
    checkLegolizeSettings(parsed.settings);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(osgLego::fuzz::toText(data, size));
    checkSettings<osgLego::LegoSettings>(text);
    checkSettings<osgLego::AmbientOcclusionSettings>(text);
    checkLegolizeSettings(text);
    checkName(text);
    checkName(text + ".legolize");
    const LegolizeOptions options = LegolizeOptions::parse(text);
    checkLegolizeSettings(options.settings);
    return 0;
}
