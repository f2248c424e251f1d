#include "LDrawDocument.h"

#include <algorithm>

namespace osgLego
{

void LDrawDocument::setDefaultName(const std::string& name)
{
    if (_files.front().name.empty()) _files.front().name = name;
}

std::string LDrawDocument::normalizeName(std::string_view name)
{
    std::string result(name);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char letter)
                   {
                       if (letter == '\\') return '/';
                       return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
                   });
    constexpr std::string_view PARTS = "parts/";
    const auto place = result.rfind(PARTS);
    if (place != std::string::npos && (place == 0 || result[place - 1] == '/')) result.erase(0, place + PARTS.size());
    if (result.starts_with("p/")) result.erase(0, 2);
    return result;
}

const LDrawFile* LDrawDocument::find(const std::string& name) const
{
    const auto found = _filesByName.find(name);
    return found == _filesByName.end() ? nullptr : &_files[found->second];
}

} // namespace osgLego
