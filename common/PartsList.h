#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Palette.h>
#include <osgLego/PartType.h>

#include <map>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace osgLego
{

/** The parts that a model is built from, to order them: how many of each type and colour.
 *
 *     PartsList list;
 *     list.add(*model, palette->getColors());
 *     list.writeCsv(file);
 *
 * One thread.
 */
class PartsList
{
public:
    /** Parts of one type in one colour. */
    struct Row
    {
        const PartType* type = nullptr;
        /** Its `code` is Part::NO_CODE, and its name #RRGGBB, if it is not a colour of plastic. */
        PaletteColor color;
        bool wasMade = false; //!< whether this type was ever made in this colour
        std::size_t quantity = 0;

        double getMass() const { return type->mass * static_cast<double>(quantity); } //!< grams
    };

    /** Parts that are not those of a model, such as base plates. */
    struct Extra
    {
        std::string number; //!< of LDraw and BrickLink
        std::string name;
        PaletteColor color;
        std::size_t quantity = 0;
    };

    /** Add the parts of a model.
     * @param palette the colours that the model was built in, which override the library's colours of the same code. */
    void add(const BrickModel& model, std::span<const PaletteColor> palette);

    /** Add parts that only the written lists have, at their end: to a row of the same parts, if there is one. */
    void addExtra(Extra extra);

    /** The rows: bricks before plates, each from small to large and in the order of colours. */
    std::vector<Row> getRows() const;

    /** For each part of a model that was added, the index of its row; NO_ROW for parts in no real shape. */
    std::vector<std::size_t> findRows(const BrickModel& model) const;
    static constexpr std::size_t NO_ROW = static_cast<std::size_t>(-1);

    /** Write a table: part, name, LDraw's code and name of the colour, BrickLink's number of the colour, quantity, mass
     * of one part and of all in grams. A row with the totals ends the parts of models; each Extra follows, without a
     * mass. Values are quoted as RFC 4180 demands. */
    void writeCsv(std::ostream& stream) const;

    /** Write a wanted list of BrickLink. Parts in colours without a number of BrickLink are wanted in any colour, with
     * the colour as a remark. */
    void writeWantedList(std::ostream& stream) const;

    /** One sentence on parts that were never made in their colours; empty if there are none. */
    std::string describeNeverMade() const;
    /** One sentence on parts in colours without a number of BrickLink; empty if there are none. */
    std::string describeWithoutNumber() const;

private:
    /** The type and the colour; the index of a type in getPartTypes() orders types. */
    using Key = std::tuple<std::ptrdiff_t, std::int32_t, std::array<std::uint8_t, 3>>;

    static Key toKey(const Part& part, const PartType& type);

    std::map<Key, Row> _rows;
    std::vector<Extra> _extras;
};

} // namespace osgLego
