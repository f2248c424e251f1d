#pragma once

#include "BookletMarkup.h"
#include "BookletModel.h"
#include "BookletPicture.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace osgLego
{

/** Writes the parts list of a booklet as HTML: what is needed to order and to sort the parts. One thread. */
class BookletParts
{
public:
    /** The arguments must outlive this object.
     * @param progress is called before each picture with the name of the work. */
    BookletParts(const BookletModel& model, BookletPictureSource& pictures,
                 const std::function<void(const std::string&)>& progress, BookletMarkup& markup);

    void write();

    /** The number of calls of `progress` by write(). */
    std::size_t countPictures() const;

private:
    /** The lines below the picture of a part. */
    struct Details
    {
        std::string color;
        std::vector<std::string> codes;
    };

    static Details describe(const PartsList::Row& row);
    std::size_t countItems() const;
    double measureItem(std::size_t item) const;
    void writeSymbols();
    void writeRow(std::size_t row);
    void writeBasePlate();
    void writeDetails(const PartsList::Row& row);
    void writeTrueSize();
    std::vector<const PartType*> findLongest() const;

    const BookletModel& _model;
    BookletPictureSource& _pictures;
    const std::function<void(const std::string&)>& _progress;
    BookletMarkup& _markup;
    BookletPicture _basePlate;
};

} // namespace osgLego
