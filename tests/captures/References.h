#pragma once

#include <string>

namespace osgLego::test
{

/** Compare every PNG in a folder with the reference of the same name, and print a line for each.
 *
 * NAME.png may have more than one reference: NAME.png, NAME-2.png, NAME-3.png, and so on; any of them may match. A
 * picture matches if it is within osglegocapture's tolerance, and at most 0.02 % of the pixels (such as silhouettes)
 * are off by more than 0.1.
 *
 * If there are failures, a page is written that shows them: reference, result, and the difference amplified five times,
 * from files written next to the page. Throws CaptureError.
 * @return the number of failures, including pictures without a reference. */
int compareWithReferences(const std::string& referenceFolder, const std::string& folder, const std::string& page);

} // namespace osgLego::test
