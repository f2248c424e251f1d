#pragma once

#include "BookletModel.h"
#include "BookletPicture.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Writes pictures and lists of parts as HTML. Pictures of parts are written once, as symbols. One thread. */
class BookletMarkup
{
public:
    /** @param model must outlive this object. */
    explicit BookletMarkup(const BookletModel& model) : _model(model), _kindSizes(model.getKinds().size()) {}

    /** Set the stream to write to, which must outlive the calls of the functions below. */
    void setStream(std::ostream& stream) { _stream = &stream; }
    std::ostream& getStream() const { return *_stream; }

    /** The address of a file within the page. */
    static std::string toData(const std::string& mediaType, const std::string& bytes);

    /** Begin a sheet: half of a wide page, or a page. The caller ends the element. */
    void beginSheet();
    std::size_t getNumSheets() const { return _numSheets; }

    void writeSymbol(const std::string& id, const BookletPicture& picture);
    /** @param text the description of the picture. @param size in pixels of CSS. */
    void writeUse(const std::string& id, const std::string& text, const glm::dvec2& size);
    void writeImage(const BookletPicture& picture, const std::string& text);

    /** Write the symbol of a kind of parts, before its uses. */
    void writeKind(std::size_t kind, const BookletPicture& picture);
    void writeUseOfKind(const BookletItem& item);
    /** The size of the symbol of a kind, in pixels of CSS. */
    const glm::dvec2& getKindSize(std::size_t kind) const { return _kindSizes[kind]; }
    /** The name of the colour of a kind. */
    std::string nameColorOf(std::size_t kind) const;
    /** Write a small part of a kind with the name of its colour. */
    void writeSwatch(std::size_t kind);
    /** Write the arrows over a picture. @param letters beside the first of them. */
    void writeArrows(const BookletPicture& picture, const std::vector<std::string>& letters);
    /** Write items of a list, each a picture with a quantity. */
    void writeItems(const std::vector<BookletItem>& items);

private:
    const BookletModel& _model;
    std::ostream* _stream = nullptr;
    std::size_t _numSheets = 0;
    std::vector<glm::dvec2> _kindSizes;
};

} // namespace osgLego
