#pragma once

#include <optional>
#include <string>

namespace osgLego
{

/** Makes programs, as long as it exists, use the shaders of shaders/reference, which draw every face and every stud.
 *
 * They are the frozen baseline of the figures: they do not follow changes of shaders/, and keep their own copy of the
 * dimensions in BrickDimensions.h.
 *
 * They are built in and written to a temporary folder that OSGLEGO_SHADER_PATH names. One at a time, one thread. Throws
 * std::runtime_error when that folder can't be created. */
class ReferenceShaders
{
public:
    ReferenceShaders();
    ~ReferenceShaders();
    ReferenceShaders(const ReferenceShaders&) = delete;
    ReferenceShaders& operator=(const ReferenceShaders&) = delete;

private:
    std::string _folder;
    std::optional<std::string> _formerPath;
};

} // namespace osgLego
