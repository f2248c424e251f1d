#pragma once

#include <cstddef>
#include <string>

namespace osgLego
{

/** A bar on a terminal; prints nothing if standard error is not a terminal. One thread. */
class BookletProgress
{
public:
    BookletProgress();
    BookletProgress(const BookletProgress&) = delete;
    BookletProgress& operator=(const BookletProgress&) = delete;
    ~BookletProgress();

    /** @param share of the work that is done, 0 to 1.
     * @param work that comes next. */
    void show(double share, const std::string& work);

private:
    bool _isTerminal;
};

} // namespace osgLego
