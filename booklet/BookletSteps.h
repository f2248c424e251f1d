#pragma once

#include "BookletBags.h"
#include "BookletBlocks.h"
#include "BookletMarkup.h"
#include "BookletModel.h"
#include "BookletPicture.h"
#include "SheetArrangement.h"
#include "SimilarColors.h"

#include <cstddef>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

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
    void writeSection(std::span<const BookletBlock> blocks, const BookletBag* bag);
    void writeSheet(std::span<const BookletBlock> blocks, const Sheet& sheet);
    void writeBag(const BookletBag& bag, double scale);
    void writeBlock(const BookletBlock& block, const PlacedBlock& place);
    void addKinds(const BookletBlock& block, std::set<std::size_t>& kinds) const;
    void writeLastLine(std::size_t numParts, const std::set<std::size_t>& kinds);
    void writeContents(std::size_t chapter, const PlacedBlock& place);
    void writeBoxes(const BookletStep& step);
    void writeBox(std::size_t chapter);
    void writeSmallStep(std::size_t chapter, std::size_t index);
    void drawSubmodel(std::size_t chapter);
    void writeStep(std::size_t chapter, std::size_t index, const PlacedBlock& place);
    void writeNumber(const BookletStep& step);
    void writeCallout(const BookletStep& step);
    void writeTurn(const BookletStep& step);
    void writeNote(const BookletStep& step);
    void writeFrame(std::size_t chapter, const BookletStep& step, const BookletPicture& picture, double width);
    void writeUseOfSubmodel(std::size_t chapter, const std::string& text);
    void writeMultiplier(const BookletChapter& chapter);
    std::string describeSubmodels(std::size_t chapter) const;
    std::string describeStep(const BookletChapter& chapter, const BookletStep& step) const;

    const BookletModel& _model;
    BookletPictureSource& _pictures;
    const std::function<void(const std::string&)>& _progress;
    BookletMarkup& _markup;
    SimilarColors _similarColors;
    std::vector<bool> _isWhole; // whether the finished picture of a chapter shows all its steps
    BookletBlocks _blocks;
    std::vector<BookletBag> _bags;
    std::vector<glm::dvec2> _submodelSizes; // of their symbols, in pixels of CSS
};

} // namespace osgLego
