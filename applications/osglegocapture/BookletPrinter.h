#pragma once

#include <string>

namespace osgLego
{

/** Print a booklet to PDF on A4 sideways, by Chromium without a window, as scripts/booklet-pdf does.
 *
 * @param page the .html file. @param pdf is written atomically.
 * @return the reason, in one sentence, why the PDF was not written; empty if it was. Throws CaptureError if Chromium
 * has made it but the file can't be written, or if a signal has arrived (Cancellation). */
std::string printBooklet(const std::string& page, const std::string& pdf);

} // namespace osgLego
