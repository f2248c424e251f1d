#pragma once

namespace osgLego
{

/** Keep OSG from reading files of servers, such as http://example.org/tree.png: a model from elsewhere must not call
 * home. OSG then says that osglegocapture does not use the network. Call this before anything is read. */
void keepReadingLocal();

} // namespace osgLego
