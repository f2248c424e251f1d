#pragma once

#include <optional>
#include <string>

namespace osgLego
{

/** While this object exists, programs use the shaders in shaders/reference, which draw every face and every stud.
 *
 * These shaders are the frozen baseline of the figures: they do not follow changes in shaders/, and have their own copy
 * of the dimensions in BrickDimensions.h.
 *
 * They are embedded in the program and written to a temporary folder, to which OSGLEGO_SHADER_PATH is set. Only one
 * object may exist at a time; one thread. Throws std::runtime_error if the folder can't be created. */
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
