#pragma once

#include <string>

namespace osgLego::test
{

/** Compare every PNG of a folder with the reference of its name, and print a line for each.
 *
 * NAME.png may have more than one reference: NAME.png, NAME-2.png, NAME-3.png, and so on; any may match. Matching means
 * osglegocapture's own tolerance, and at most 0.02 % of the pixels off by more than 0.1, as those of silhouettes may
 * be.
 *
 * Those that fail are shown on a page, which is written if there are any: reference, result, and the difference made
 * five times as strong, from files written beside it. Throws CaptureError.
 * @return how many fail, for want of a reference too. */
int compareWithReferences(const std::string& referenceFolder, const std::string& folder, const std::string& page);

} // namespace osgLego::test
