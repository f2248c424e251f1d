#pragma once

#include <osgLegoBooklet/Booklet.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace osgLego
{

/** Ends the making of a booklet. It never leaves the library: its functions return the error. */
class BookletFailure : public std::runtime_error
{
public:
    BookletFailure(BookletError::Reason reason, const std::string& message) :
        std::runtime_error(message), _error{reason, message}
    {
    }

    const BookletError& getError() const { return _error; }

private:
    BookletError _error;
};

} // namespace osgLego
