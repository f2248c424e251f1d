#include "SettingsField.h"

std::string readSettingsField(osgDB::InputStream& stream)
{
    std::string text;
    stream >> text;
    const bool isQuoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return isQuoted ? text.substr(1, text.size() - 2) : text;
}
