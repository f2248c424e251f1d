#pragma once

#include "SheetFilling.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** A step, or the contents of a submodel, on a sheet. Lengths are millimetres on A5; larger paper enlarges sheets. */
struct SheetBlock
{
    static constexpr std::size_t MOST_COLUMNS = 3;

    /** The height of all but the picture, for sheets of one, two and three columns; SheetFilling::IMPOSSIBLE where the
     * block can't be in so many. On a sheet of one column, at most SheetArrangement::MOST_HEAD. */
    std::array<double, MOST_COLUMNS> heads{};
    std::array<double, MOST_COLUMNS> scales{1.0, 1.0, 1.0}; //!< of its texts and lists, likewise
    glm::dvec2 studs{0.0};                                  //!< the size of the picture, in studs; 0 without one
    bool hasScale = true;   //!< whether the picture has the scale of the section, or its own one
    double mostPitch = 8.0; //!< the largest picture of a stud; 8 is true to life
    double lostWidth = 0.0; //!< of the column, which the picture can't use
    bool isHeading = false; //!< whether it belongs on the sheet of the block behind it
};

/** Where a block is printed. */
struct PlacedBlock
{
    std::size_t block = 0;
    double height = 0.0;
    double space = 0.0; //!< below it
    double pitch = 0.0; //!< of a stud
    double scale = 1.0; //!< of its texts and lists
};

/** Blocks below each other. */
using SheetColumn = std::vector<PlacedBlock>;

/** A page of paper. */
struct Sheet
{
    std::size_t numColumns = 1; //!< by which its width is divided
    std::vector<SheetColumn> columns;
};

/** Arranges the blocks of a section on sheets: in columns, from top to bottom, so that all sheets are nearly equally
 * full. Pictures of the section's model have the same scale, unless a block would be higher than its column, or a sheet
 * not half full. Most sheets have the same number of columns; this and the scale make few sheets and large pictures.
 *
 *     for (const Sheet& sheet : SheetArrangement(blocks, header).getSheets()) ...
 *
 * Immutable. Uses no GL. */
class SheetArrangement
{
public:
    static constexpr double WIDTH = 128.0;        //!< of a sheet
    static constexpr double HEIGHT = 176.5;       //!< likewise, for blocks: below half a millimetre, above a last line
    static constexpr double COLUMN_SPACE = 6.0;   //!< between columns
    static constexpr double BLOCK_SPACE = 5.0;    //!< between blocks at least
    static constexpr double PICTURE_SPACE = 2.0;  //!< above a picture
    static constexpr double LARGE_PITCH = 4.0;    //!< of a stud; larger ones are no better
    static constexpr double LEAST_PICTURE = 25.0; //!< the height of pictures, which are smaller only at their scale
    static constexpr double MOST_BODY = 0.75 * HEIGHT; //!< of a block with a picture of the least height
    static constexpr double MOST_HEAD = MOST_BODY - PICTURE_SPACE - LEAST_PICTURE;

    /** How much higher than one line the foot of a sheet is, which takes that height from its columns.
     * @param first of its blocks. @param end behind the last of them. @return up to MOST_FOOT. */
    using FootFunction = std::function<double(std::size_t first, std::size_t end)>;
    static constexpr double MOST_FOOT = HEIGHT - MOST_BODY;

    /** The width of a column. @param numColumns 1 to SheetBlock::MOST_COLUMNS. */
    static double getColumnWidth(std::size_t numColumns);

    /** @param blocks at least one; they must outlive this object.
     * @param header the height of the header of the first sheet, up to HEIGHT. The sheet may have nothing else if that
     * is more than half of it, or if no block fits below it.
     * @param mostColumns 1 to SheetBlock::MOST_COLUMNS.
     * @param getFoot null if each foot is one line.
     * @throws std::invalid_argument if a block is higher than a sheet. */
    SheetArrangement(std::span<const SheetBlock> blocks, double header,
                     std::size_t mostColumns = SheetBlock::MOST_COLUMNS, const FootFunction& getFoot = nullptr);

    const std::vector<Sheet>& getSheets() const { return _sheets; }

private:
    /** Some blocks on a sheet. */
    struct Part
    {
        std::size_t first = 0;
        std::size_t numColumns = 1;
        std::vector<std::size_t> ends; // of the columns
        double foot = 0.0;
        double growth = 1.0; // of its pictures
    };

    /** The best way to place all blocks from the first on up to some other. */
    struct Plan
    {
        double cost = SheetFilling::IMPOSSIBLE; // in sheets
        Part last;                              // sheet
    };

    /** The usual number of columns, and the scale. */
    struct Choice
    {
        double cost = SheetFilling::IMPOSSIBLE;
        std::size_t numColumns = 1;
        double pitch = 0.0;
    };

    Choice choose(std::size_t mostColumns);
    double findWidestPitch() const;
    std::vector<Plan> plan() const;
    void extendPlans(std::size_t first, std::size_t numColumns, std::vector<Plan>& plans) const;
    void extendPlans(const Part& start, std::vector<Plan>& plans) const;
    double rate(Part& part) const;
    void enlarge(Part& part) const;
    bool isEmpty(const Part& part) const;
    double getCapacity(const Part& part) const;
    double getFoot(std::size_t first, std::size_t numBlocks) const;
    double getPitch(const SheetBlock& block, const Part& part, double capacity) const;
    double getHeight(const SheetBlock& block, const Part& part) const;
    double rateReduction(const Part& part) const;
    void createSheets(const std::vector<Plan>& plans);
    SheetColumn createColumn(std::size_t first, std::size_t end, const Part& part) const;

    std::span<const SheetBlock> _blocks;
    double _header;
    std::vector<std::vector<double>> _feet; // by the first block, and by the number of blocks less one
    bool _isHeaderAlone = false;            // on a sheet
    std::size_t _numColumns = 1;
    double _pitch = 0.0; // of pictures of the model
    std::vector<Sheet> _sheets;
};

} // namespace osgLego
