#include "Harness.h"

#include <osgLego/Palette.h>
#include <osgLego/palette/ColorConfiguration.h>
#include <osgLego/palette/ColorTable.h>
#include <osgLego/palette/KnownColors.h>

#include <vector>

// The texts of palettes: tables of colours (.csv), and configurations of LDraw (.ldr).

namespace
{

using osgLego::fuzz::require;

/** Making the tables of a palette takes too long to do it for each input, and depends on the colours alone. */
void checkColors(const std::vector<osgLego::PaletteColor>& colors, const std::string& error)
{
    require(colors.empty() != error.empty(), "there are colours, or there is a reason: " + error);
    require(colors.size() <= osgLego::Palette::MAXIMUM_COLORS, "there are not too many colours");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = osgLego::fuzz::toText(data, size);
    std::string error;
    checkColors(osgLego::readColorTable(text, error), error);
    error.clear();
    checkColors(osgLego::readColorConfiguration(text, osgLego::getKnownColors(), error), error);
    return 0;
}
