#pragma once

#include "BookletModel.h"
#include "BookletPicture.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace osgLego
{

/** A file that readers save from the page. */
struct BookletDownload
{
    std::string label;
    std::string fileName;
    std::string mediaType;
    std::string content;
};

/** The content of the page that does not follow from the model's parts and steps. */
struct BookletFacts
{
    std::string title;
    std::string author;                //!< empty: none on the cover
    std::vector<std::string> warnings; //!< sentences for the cover
    std::vector<BookletDownload> downloads;
    std::size_t firstStep = 0; //!< the main steps to write
    std::size_t endStep = 0;   //!< behind the last of them
};

/** Writes a booklet as one HTML file without links to others. One thread. */
class BookletPage
{
public:
    /** @param progress is called before each picture with the name of the work. The other arguments must outlive this
     * object. */
    BookletPage(const BookletModel& model, const BookletFacts& facts, BookletPictureSource& pictures,
                std::function<void(const std::string&)> progress);

    void write(std::ostream& stream);

    /** The number of calls of `progress` by write(). */
    std::size_t countPictures() const;

private:
    void writeHead();
    void writeCover();
    void writeFacts();
    void writePartsList();
    void writeBasePlate();
    void writeDetails(const PartsList::Row& row);
    void writeSteps();
    void writeSubmodels(const BookletStep& step);
    void writeSubmodel(std::size_t chapter);
    void writeStep(std::size_t chapter, std::size_t index);
    void writeCallout(const BookletStep& step);
    void writeNote(const BookletStep& step);
    void writeArrows(const BookletStep& step, const BookletPicture& picture);
    void writeItems(const std::vector<BookletItem>& items);
    void writeItem(const BookletItem& item);
    void writeFinished();
    void writeSymbol(const std::string& id, const BookletPicture& picture);
    void writeUse(const std::string& id, const std::string& text, const glm::dvec2& size);
    void writeImage(const BookletPicture& picture, const std::string& text);
    std::string describeStep(const BookletChapter& chapter, const BookletStep& step) const;
    std::size_t countStepPictures(const BookletChapter& chapter, std::size_t first, std::size_t end) const;

    const BookletModel& _model;
    const BookletFacts& _facts;
    BookletPictureSource& _pictures;
    std::function<void(const std::string&)> _progress;
    std::ostream* _stream = nullptr;
    std::vector<glm::dvec2> _kindSizes;     // in pixels of CSS
    std::vector<glm::dvec2> _submodelSizes; // likewise, of their symbols
};

} // namespace osgLego
