#pragma once

#include <optional>
#include <string>

namespace osgLego
{

/** While it lives, programs are made of the shaders of shaders/reference, which draw every face and every stud.
 *
 * They are the baseline of the figures, frozen as they were: no file of theirs is to follow a change of shaders/, and
 * what they repeat of BrickDimensions.h stays.
 *
 * They are built in, and stand in a temporary folder that OSGLEGO_SHADER_PATH names. One at a time, one thread. Throws
 * std::runtime_error when that folder can't be made. */
class ReferenceShaders
{
public:
    ReferenceShaders();
    ~ReferenceShaders();
    ReferenceShaders(const ReferenceShaders&) = delete;
    ReferenceShaders& operator=(const ReferenceShaders&) = delete;

private:
    void removeFolder() const;

    std::string _folder;
    std::optional<std::string> _formerPath;
};

} // namespace osgLego
