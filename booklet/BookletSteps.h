#pragma once

#include "BookletBags.h"
#include "BookletBlockMarkup.h"
#include "BookletBlocks.h"
#include "BookletMarkup.h"
#include "BookletModel.h"
#include "BookletPicture.h"
#include "SheetArrangement.h"
#include "SheetMeasures.h"
#include "SimilarColors.h"

#include <cstddef>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace osgLego
{

/** Writes the steps of a booklet as HTML. Submodels come before the step that attaches them, or, if they are small, in
 * a box within it. One thread. */
class BookletSteps
{
public:
    /** The other arguments must outlive this object.
     * @param progress is called before each picture with the name of the work. */
    BookletSteps(const BookletModel& model, BookletPictureSource& pictures,
                 const std::function<void(const std::string&)>& progress, BookletMarkup& markup);

    /** Write some steps of the main model. */
    void write(std::size_t first, std::size_t end);

    /** The number of calls of `progress` by write(). */
    std::size_t countPictures(std::size_t first, std::size_t end) const;

private:
    std::size_t countPictures(const BookletChapter& chapter, std::size_t first, std::size_t end) const;
    std::vector<bool> findWhole() const;
    std::vector<BookletBlock> divide(std::span<const BookletBlock> blocks, const SheetMeasures& measures) const;
    void writeSection(std::span<const BookletBlock> undivided, const BookletBag* bag);
    void writeSheet(std::span<const BookletBlock> blocks, const Sheet& sheet);
    void writeBag(const BookletBag& bag, const SheetHeader& header, std::span<const BookletBlock> blocks);
    void addKinds(const BookletBlock& block, std::set<std::size_t>& kinds) const;
    std::vector<std::size_t> chooseKinds(std::span<const BookletBlock> blocks) const;
    std::vector<std::string> nameColors(std::span<const BookletBlock> blocks) const;
    void writeFoot(std::span<const BookletBlock> blocks);

    const BookletModel& _model;
    BookletPictureSource& _pictures;
    const std::function<void(const std::string&)>& _progress;
    BookletMarkup& _markup;
    SimilarColors _similarColors;
    std::vector<bool> _isWhole; // whether the finished picture of a chapter shows all its steps
    BookletBlocks _blocks;
    std::vector<BookletBag> _bags;
    BookletBlockMarkup _blockMarkup;
};

} // namespace osgLego
