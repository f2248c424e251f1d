#pragma once

#include <string>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego::test
{

/** Make GL report errors in a context to this process. The context is made current and released. */
void watchGl(osg::GraphicsContext& context);

/** The errors and messages of high severity since the last call. */
std::vector<std::string> takeGlMessages();

} // namespace osgLego::test
