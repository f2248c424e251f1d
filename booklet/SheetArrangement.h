#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** A step, or the contents of a submodel, on a sheet. Lengths are millimetres on A5; larger paper enlarges sheets. */
struct SheetBlock
{
    static constexpr std::size_t MOST_COLUMNS = 3;

    /** The height of all but the picture, for sheets of one, two and three columns. */
    std::array<double, MOST_COLUMNS> heads{};
    glm::dvec2 studs{0.0};  //!< the size of the picture, in studs; 0 without one
    bool isOfModel = true;  //!< whether the picture has the scale of the others of the model, or its own one
    double mostPitch = 8.0; //!< the largest picture of a stud; 8 is true to life
    double lostWidth = 0.0; //!< of the column, which the picture can't use
};

/** Where a block is printed. */
struct PlacedBlock
{
    std::size_t block = 0;
    double height = 0.0;
    double space = 0.0; //!< below it
    double pitch = 0.0; //!< of a stud
};

/** Blocks below each other. */
using SheetColumn = std::vector<PlacedBlock>;

/** Arranges the blocks of a section on sheets: in columns, from top to bottom, so that all sheets are nearly equally
 * full. Pictures of the model have the same scale, unless a block would be higher than a sheet. The number of columns
 * and the scale make few sheets and large pictures.
 *
 *     for (const std::vector<SheetColumn>& sheet : SheetArrangement(blocks, header).getSheets()) ...
 *
 * Immutable. Uses no GL. */
class SheetArrangement
{
public:
    static constexpr double WIDTH = 128.0;       //!< of a sheet
    static constexpr double HEIGHT = 177.0;      //!< likewise, above its last line
    static constexpr double COLUMN_SPACE = 6.0;  //!< between columns
    static constexpr double BLOCK_SPACE = 5.0;   //!< between blocks at least
    static constexpr double PICTURE_SPACE = 2.0; //!< above a picture

    /** The width of a column. @param numColumns 1 to SheetBlock::MOST_COLUMNS. */
    static double getColumnWidth(std::size_t numColumns);

    /** @param blocks at least one; they must outlive this object.
     * @param header the height of the header of the first sheet.
     * @param mostColumns 1 to SheetBlock::MOST_COLUMNS. */
    SheetArrangement(std::span<const SheetBlock> blocks, double header,
                     std::size_t mostColumns = SheetBlock::MOST_COLUMNS);

    std::size_t getNumColumns() const { return _numColumns; }
    /** The columns of each sheet, at least one. */
    const std::vector<std::vector<SheetColumn>>& getSheets() const { return _sheets; }

private:
    void chooseColumns(std::size_t mostColumns);
    double getCapacity(std::size_t column) const;
    double findWidestPitch() const;
    double getPitch(const SheetBlock& block) const;
    double getHeight(const SheetBlock& block) const;
    std::size_t countColumns() const;
    std::size_t countFullColumns() const;
    std::size_t countEmpty(const std::vector<std::size_t>& ends) const;
    std::vector<std::size_t> divide(std::size_t numColumns) const;
    SheetColumn createColumn(std::size_t first, std::size_t end, double capacity) const;

    std::span<const SheetBlock> _blocks;
    double _header;
    std::size_t _numColumns = 1;
    double _pitch = 0.0;
    std::vector<std::vector<SheetColumn>> _sheets;
};

} // namespace osgLego
