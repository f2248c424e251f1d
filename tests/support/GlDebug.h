#pragma once

#include <string>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego::test
{

/** Have GL report to this process what goes wrong in a context, which is made current and released. */
void watchGl(osg::GraphicsContext& context);

/** The errors and messages of high severity since this was asked for last. */
std::vector<std::string> takeGlMessages();

} // namespace osgLego::test
