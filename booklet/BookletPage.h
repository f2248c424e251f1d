#pragma once

#include "BookletMarkup.h"
#include "BookletModel.h"
#include "BookletParts.h"
#include "BookletPicture.h"
#include "BookletSteps.h"

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
    void writeFinished();

    const BookletModel& _model;
    const BookletFacts& _facts;
    BookletPictureSource& _pictures;
    std::function<void(const std::string&)> _progress;
    std::ostream* _stream = nullptr;
    BookletMarkup _markup;
    BookletParts _parts;
    BookletSteps _steps;
};

} // namespace osgLego
