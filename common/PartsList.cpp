#include <common/PartsList.h>

#include <common/MarkupText.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string_view>

namespace osgLego
{

namespace
{

const PaletteColor* findCode(std::span<const PaletteColor> colors, std::int32_t code)
{
    const auto found =
        std::find_if(colors.begin(), colors.end(), [code](const PaletteColor& color) { return color.code == code; });
    return found == colors.end() ? nullptr : &*found;
}

std::string hexadecimal(const std::array<std::uint8_t, 3>& color)
{
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02X%02X%02X", color[0], color[1], color[2]);
    return text.data();
}

/** The colour of a part. One that is in no list exists in no size. */
PaletteColor findColor(const Part& part, std::span<const PaletteColor> palette)
{
    if (part.colorCode != Part::NO_CODE)
        for (const std::span<const PaletteColor> colors : {palette, Palette::getKnownColors()})
            if (const PaletteColor* color = findCode(colors, part.colorCode)) return *color;
    PaletteColor color;
    color.code = part.colorCode;
    color.name = hexadecimal(part.color);
    color.color = part.color;
    color.bricks = 0;
    color.plates = 0;
    return color;
}

bool wasMade(const PartType& type, const PaletteColor& color)
{
    const std::uint16_t sizes = type.family == PartFamily::BRICK ? color.bricks : color.plates;
    return (sizes >> type.getSizeIndex() & 1) != 0;
}

std::string formatMass(double grams)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.2f", grams);
    return text.data();
}

std::string quotedForCsv(const std::string& value)
{
    if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
    std::string quoted = "\"";
    for (const char letter : value)
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

/** A number, or nothing if there is none. */
std::string optionalNumber(std::int32_t number)
{
    return number < 0 ? std::string() : std::to_string(number);
}

/** "17 parts of 3 kinds", for example, and the most frequent kind; empty if no row satisfies the condition. */
std::string describe(const std::vector<PartsList::Row>& rows, const std::function<bool(const PartsList::Row&)>& isMeant)
{
    std::size_t quantity = 0;
    std::size_t kinds = 0;
    const PartsList::Row* most = nullptr;
    for (const PartsList::Row& row : rows)
        if (isMeant(row))
        {
            quantity += row.quantity;
            ++kinds;
            if (!most || row.quantity > most->quantity) most = &row;
        }
    if (!most) return {};
    return std::to_string(quantity) + (quantity == 1 ? " part" : " parts") +
           (kinds == 1 ? " ("
                       : " of " + std::to_string(kinds) + " kinds (" +
                             (2 * most->quantity > quantity ? "most of them " : "for example ")) +
           most->type->getName() + " in " + most->color.name + ")";
}

} // namespace

PartsList::Key PartsList::toKey(const Part& part, const PartType& type)
{
    return {&type - getPartTypes().data(), part.colorCode, part.color};
}

void PartsList::add(const BrickModel& model, std::span<const PaletteColor> palette)
{
    for (const Part& part : model.getParts())
    {
        const PartType* type = findPartType(part, model.getGrid());
        if (!type) continue;
        Row& row = _rows[toKey(part, *type)];
        if (row.quantity++ > 0) continue;
        row.type = type;
        row.color = findColor(part, palette);
        row.wasMade = wasMade(*type, row.color);
    }
}

void PartsList::addExtra(Extra extra)
{
    const auto same = std::find_if(_extras.begin(), _extras.end(),
                                   [&extra](const Extra& other)
                                   { return other.number == extra.number && other.color.code == extra.color.code; });
    if (same != _extras.end())
        same->quantity += extra.quantity;
    else
        _extras.push_back(std::move(extra));
}

std::vector<PartsList::Row> PartsList::getRows() const
{
    std::vector<Row> rows;
    rows.reserve(_rows.size());
    for (const auto& [key, row] : _rows)
        rows.push_back(row);
    return rows;
}

std::vector<std::size_t> PartsList::findRows(const BrickModel& model) const
{
    std::map<Key, std::size_t> places;
    for (const auto& [key, row] : _rows)
        places.emplace_hint(places.end(), key, places.size());
    std::vector<std::size_t> rows;
    rows.reserve(model.getParts().size());
    for (const Part& part : model.getParts())
    {
        const PartType* type = findPartType(part, model.getGrid());
        rows.push_back(type ? places.at(toKey(part, *type)) : NO_ROW);
    }
    return rows;
}

void PartsList::writeCsv(std::ostream& stream) const
{
    stream << "part,name,ldraw_color,color_name,bricklink_color,quantity,mass,total_mass\n";
    std::size_t quantity = 0;
    double mass = 0.0;
    const auto writeParts = [&](std::string_view number, const std::string& name, const PaletteColor& color,
                                std::size_t count, const std::string& masses)
    {
        stream << number << ',' << quotedForCsv(name) << ',' << optionalNumber(color.code) << ','
               << quotedForCsv(color.name) << ',' << optionalNumber(color.brickLink) << ',' << count << ',' << masses
               << '\n';
    };
    for (const Row& row : getRows())
    {
        writeParts(row.type->number, row.type->getName(), row.color, row.quantity,
                   formatMass(row.type->mass) + ',' + formatMass(row.getMass()));
        quantity += row.quantity;
        mass += row.getMass();
    }
    for (const Extra& extra : _extras)
    {
        writeParts(extra.number, extra.name, extra.color, extra.quantity, ",");
        quantity += extra.quantity;
    }
    stream << "total,,,,," << quantity << ",," << formatMass(mass) << '\n';
}

void PartsList::writeWantedList(std::ostream& stream) const
{
    // BrickLink refuses a list that begins with an XML declaration.
    stream << "<INVENTORY>\n";
    const auto writeItem = [&](std::string_view number, const PaletteColor& color, std::size_t quantity)
    {
        stream << "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>" << number << "</ITEMID>";
        if (color.brickLink >= 0) stream << "<COLOR>" << color.brickLink << "</COLOR>";
        stream << "<MINQTY>" << quantity << "</MINQTY>";
        if (color.brickLink < 0) stream << "<REMARKS>" << escapedForMarkup(color.name) << "</REMARKS>";
        stream << "</ITEM>\n";
    };
    for (const Row& row : getRows())
        writeItem(row.type->number, row.color, row.quantity);
    for (const Extra& extra : _extras)
        writeItem(extra.number, extra.color, extra.quantity);
    stream << "</INVENTORY>\n";
}

std::string PartsList::describeNeverMade() const
{
    const std::string parts = describe(getRows(), [](const Row& row) { return !row.wasMade; });
    return parts.empty() ? parts : "never made in this size and colour: " + parts;
}

std::string PartsList::describeWithoutNumber() const
{
    const std::string parts = describe(getRows(), [](const Row& row) { return row.color.brickLink < 0; });
    return parts.empty() ? parts : "in a colour without a number of BrickLink: " + parts;
}

} // namespace osgLego
