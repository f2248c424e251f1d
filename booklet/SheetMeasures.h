#pragma once

#include "BookletBlocks.h"
#include "BookletMarkup.h"
#include "BookletModel.h"
#include "BookletPicture.h"
#include "SheetArrangement.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** A heading and a list of parts across a sheet. */
struct SheetHeader
{
    std::vector<BookletItem> items;
    double height = 0.0; //!< in millimetres on A5, up to SheetArrangement::HEIGHT
    double scale = 1.0;  //!< of its texts and lists
};

/** The foot of a sheet. */
struct SheetFoot
{
    double more = 0.0;  //!< its height beyond one line, in millimetres on A5, up to SheetArrangement::MOST_FOOT
    double scale = 1.0; //!< of the names of colours
};

/** Measures the blocks of sheets before they are written, as Booklet.css prints them: in millimetres on A5. Blocks
 * whose texts turn out higher have smaller pictures. Long lists are printed smaller, so that they and a picture fit on
 * a sheet, but all texts are at least 2 mm high; lists that do not fit so are divided.
 *
 * One thread. */
class SheetMeasures
{
public:
    /** @param isWhole for each chapter, whether its finished picture shows all its steps. The other arguments must
     * outlive this object. */
    SheetMeasures(const BookletModel& model, const BookletPictureSource& pictures, const BookletMarkup& markup,
                  const std::vector<bool>& isWhole);

    /** @param hasScale whether pictures of the chapter have one scale in their section. */
    SheetBlock measureStep(std::size_t chapter, std::size_t step, bool hasScale) const;
    /** The contents of a submodel of many parts. */
    SheetBlock measureSubmodel(const BookletBlock& block) const;
    /** Divide the list of the contents of a submodel into as few lists as fit on a sheet each, nearly equally long. */
    std::vector<std::vector<BookletItem>> divideContents(const BookletBlock& contents) const;
    /** A list of parts, likewise divided: blocks may be below the last of the headers only. */
    std::vector<SheetHeader> measureHeaders(const std::vector<BookletItem>& items) const;
    /** The foot of a sheet that names some colours. Hundreds of them are less than 2 mm high. */
    static SheetFoot measureColors(const std::vector<std::string>& names);
    /** The size of a picture in the box of a submodel. */
    static glm::dvec2 toBox(const glm::dvec2& studs);
    /** The size of the picture of a finished submodel of many parts. */
    glm::dvec2 measureContents(std::size_t chapter) const;

private:
    using Sizes = std::vector<glm::dvec2>;
    /** The height of something by its width. */
    using HeightFunction = std::function<double(double)>;

    static void findScales(const HeightFunction& measure, double most, SheetBlock& block);
    double measureHead(const BookletChapter& chapter, const BookletStep& step, double width) const;
    double measureSubmodel(const BookletBlock& block, double width) const;
    static std::vector<std::vector<BookletItem>>
    divide(const std::vector<BookletItem>& items, const std::function<bool(const std::vector<BookletItem>&)>& fits);
    SheetHeader measureHeader(const std::vector<BookletItem>& items) const;
    glm::dvec2 measureItem(const BookletItem& item) const;
    glm::dvec2 measureUse(std::size_t chapter, double most) const;
    Sizes measureItems(const std::vector<BookletItem>& items) const;
    Sizes measureEntries(const std::vector<std::size_t>& submodels, const std::vector<BookletItem>& items,
                         double most) const;
    double measureCallout(const BookletStep& step, double width) const;
    Sizes measureBoxes(const BookletStep& step, double width) const;
    glm::dvec2 measureBox(std::size_t chapter, double width) const;

    const BookletModel& _model;
    const BookletPictureSource& _pictures;
    const BookletMarkup& _markup;
    const std::vector<bool>& _isWhole;
};

} // namespace osgLego
