#pragma once

#include <chrono>
#include <string>

namespace osgLego
{

/** Shows the progress of long work in a line on a terminal. If standard error is not a terminal, work that takes longer
 * than half a minute prints a line twice a minute.
 *
 *     ProgressBar progress;
 *     progress.show("reading");
 *     progress.show(0.5, "step 2 of 4");
 *     progress.clear(); // before anything else is printed
 *
 * One thread at a time.
 */
class ProgressBar
{
public:
    ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();

    /** Let the bars that follow be a part of the whole work: from `first` to `last`, shares of 0 to 1. */
    void setRange(double first, double last);
    /** Show work that does not tell how much of it is done. */
    void show(const std::string& work) const;
    /** Show a bar.
     * @param share of the work that is done, 0 to 1.
     * @param work that comes next. */
    void show(double share, const std::string& work) const;
    /** Remove the line. */
    void clear() const;
    /** Remove the line, and print a warning, unless it is empty. */
    void warn(const std::string& warning) const;

private:
    void printSometimes(const std::string& text) const;

    bool _isTerminal;
    double _first = 0.0;
    double _last = 1.0;
    mutable std::chrono::steady_clock::time_point _printed; // the last line, if this is no terminal
};

} // namespace osgLego
