#pragma once

#include <string>

namespace osgLego::test
{

/** Compare every PNG in a folder with the reference of the same name, and print a line for each.
 *
 * The references of NAME.png are NAME.png and NAME.RENDERER.png, for example NAME.mesa-25.png; any of them may match. A
 * picture matches if its mean error is at most 0.002 levels of 255, and at most two pixels have a channel that is off
 * by more than 3 levels. The renderer must be pinned, see captures-test.
 *
 * If there are failures, a page is written that shows them: reference, result, and the difference amplified five times,
 * from files written next to the page. Throws CaptureError.
 * @return the number of failures, including pictures without a reference. */
int compareWithReferences(const std::string& referenceFolder, const std::string& folder, const std::string& page);

} // namespace osgLego::test
