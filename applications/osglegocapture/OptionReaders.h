#pragma once

#include "CaptureOptions.h"

#include <limits>
#include <string>
#include <string_view>

namespace osgLego
{

// Functions that read the text of an option. Each returns an error message for the user, with the bad value and what
// was expected, or nothing if the options have the value now.

inline constexpr double MAXIMUM_NUMBER = std::numeric_limits<double>::max();

/** The valid range of an option's number, and its description in messages. */
struct NumberRange
{
    double minimum;
    double maximum;
    const char* text;
};

/** Read a number for `option`. */
std::string readNumber(const char* option, const std::string& text, const NumberRange& range, double& number);

/** Read --size. */
std::string readSize(const std::string& text, CaptureOptions& options);
/** Read --view. */
std::string readView(const std::string& text, CaptureOptions& options);
/** Read --occlusion. */
std::string readOcclusion(const std::string& text, CaptureOptions& options);
/** Read --steps. */
std::string readSteps(const std::string& text, CaptureOptions& options);
/** Read --context. */
std::string readContext(const std::string& text, ContextKind& kind);
/** Read --base. */
std::string readBase(const std::string& text, CaptureOptions& options);
/** Read --load, X,Y,Z=200g; each call adds a weight. */
std::string readLoad(const std::string& text, CaptureOptions& options);
/** Read --length, such as 20cm, 200mm or 8in. */
std::string readLength(const std::string& text, CaptureOptions& options);
/** Read --parts. */
std::string readParts(const std::string& text, CaptureOptions& options);

/** @return one sentence that names an option of this program, if the settings have a key that is its setting in names
 * with .legolize; otherwise empty. */
std::string findKeyOfOption(std::string_view settings);

} // namespace osgLego
