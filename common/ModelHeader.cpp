#include <common/ModelHeader.h>

#include <array>
#include <utility>

#include <osg/ValueObject>

namespace osgLego
{

namespace
{

/** The user values, and the texts that they hold. */
constexpr std::array<std::pair<const char*, std::string ModelHeader::*>, 3> TEXTS{
    {{"title", &ModelHeader::title}, {"author", &ModelHeader::author}, {"license", &ModelHeader::license}}};

} // namespace

ModelHeader ModelHeader::find(const osg::Object& object)
{
    ModelHeader header;
    for (const auto& [name, text] : TEXTS)
        object.getUserValue(name, header.*text);
    return header;
}

void ModelHeader::store(osg::Object& object) const
{
    for (const auto& [name, text] : TEXTS)
        if (!(this->*text).empty()) object.setUserValue(name, this->*text);
}

void ModelHeader::complete(const ModelHeader& other)
{
    for (const auto& [name, text] : TEXTS)
        if ((this->*text).empty()) this->*text = other.*text;
}

void ModelHeader::keepEqual(const ModelHeader& other)
{
    for (const auto& [name, text] : TEXTS)
        if (this->*text != other.*text) (this->*text).clear();
}

} // namespace osgLego
