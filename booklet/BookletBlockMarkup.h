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

namespace osgLego
{

/** Writes the blocks of sheets as HTML: steps with the boxes of their small submodels, and contents of submodels. One
 * thread. */
class BookletBlockMarkup
{
public:
    /** @param progress is called before each picture with the name of the work.
     * @param isWhole for each chapter, whether its finished picture shows all its steps. The other arguments must
     * outlive this object, too. */
    BookletBlockMarkup(const BookletModel& model, BookletPictureSource& pictures,
                       const std::function<void(const std::string&)>& progress, BookletMarkup& markup,
                       const std::vector<bool>& isWhole);

    void write(const BookletBlock& block, const PlacedBlock& place);

private:
    void writeContents(const BookletBlock& block, const PlacedBlock& place);
    void writeMoreContents(const BookletBlock& block, const PlacedBlock& place);
    void writeList(const std::vector<std::size_t>& submodels, const std::vector<BookletItem>& items);
    void writeBoxes(const BookletStep& step);
    void writeBox(std::size_t chapter);
    void writeSmallStep(std::size_t chapter, std::size_t index);
    void drawSubmodel(std::size_t chapter);
    void writeStep(std::size_t chapter, std::size_t index, const PlacedBlock& place);
    void writeNumber(const BookletStep& step);
    void writeCallout(const BookletStep& step);
    void writeTurn(const BookletStep& step);
    void writeNote(const BookletChapter& chapter, const BookletStep& step);
    void writeFrame(std::size_t chapter, const BookletStep& step, const BookletPicture& picture, double width);
    void writeUseOfSubmodel(std::size_t chapter, const std::string& text);
    void writeMultiplier(const BookletChapter& chapter);
    std::string describeSubmodels(std::size_t chapter) const;
    std::string describeStep(const BookletChapter& chapter, const BookletStep& step) const;

    const BookletModel& _model;
    BookletPictureSource& _pictures;
    const std::function<void(const std::string&)>& _progress;
    BookletMarkup& _markup;
    const std::vector<bool>& _isWhole;
};

} // namespace osgLego
