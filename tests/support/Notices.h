#pragma once

#include <functional>
#include <string>

namespace osgLego::test
{

/** The text that OSG's notify handler receives while a function runs. */
std::string noticesOf(const std::function<void()>& function);

} // namespace osgLego::test
