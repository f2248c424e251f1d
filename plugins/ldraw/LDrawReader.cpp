#include "LDrawReader.h"

#include "LDrawGeometry.h"
#include "LDrawParser.h"
#include "LDrawText.h"

#include <common/BasePlate.h>
#include <common/NameList.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <utility>

namespace osgLego
{

namespace
{

using Counts = std::map<std::string, std::size_t>;

Counts countByName(const std::vector<LDrawPart>& parts)
{
    Counts counts;
    for (const LDrawPart& part : parts)
        ++counts[toPartFile(part.type->number)];
    return counts;
}

bool isBasePlate(const Counts::value_type& entry)
{
    return BasePlate::isNumber(toPartNumber(entry.first));
}

std::string textOf(const Counts::value_type& entry)
{
    constexpr std::size_t LONGEST = 80;
    const auto& [name, count] = entry;
    return name.substr(0, LONGEST) + (name.size() > LONGEST ? "..." : "") +
           (count > 1 ? " (" + std::to_string(count) + " times)" : "");
}

std::string textOf(std::int32_t color)
{
    return std::to_string(color);
}

template <typename Entries>
std::string join(const Entries& entries)
{
    constexpr std::size_t MOST = 20;
    return listNames(entries, MOST, [](const auto& entry) { return textOf(entry); });
}

osg::ref_ptr<osg::Node> createLegoNode(const std::string& name, const BrickModel& model)
{
    LegoSettings settings;
    settings.grid.proportions = getCellPlates(model.getGrid()) == 1 ? Proportions::PLATE : Proportions::BRICK;
    settings.parts.set = PartSet::BRICKS;
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->setName(name);
    lego->setStoredBricks(&model);
    return lego;
}

} // namespace

osg::ref_ptr<osg::Node> LDrawReader::read(const std::string& text, std::string& error)
{
    const std::optional<LDrawDocument> document = LDrawParser::parse(text, error);
    if (!document) return nullptr;
    LDrawResolver resolver(*document, _library);
    error = resolver.resolve();
    if (!error.empty()) return nullptr;
    LDrawColors colors;
    colors.add(_library.readColors());
    colors.add(document->getColors());
    LDrawBricks bricks = LDrawBricks::create(resolver.getParts(), colors, error);
    if (error.empty()) error = addSurfaces(bricks.offLattice, resolver);
    if (!error.empty()) return nullptr;
    addWarnings(bricks, resolver);
    if (bricks.model || !resolver.getTriangles().empty()) return createScene(bricks, *document, resolver, colors);
    error = "it has no bricks or plates that can be shown; expected upright parts such as 3001.dat";
    if (!_library.hasParts() && !resolver.getMissing().empty())
        error += ", or LDRAWDIR as the folder of a part library";
    for (const std::string& warning : std::exchange(_warnings, {}))
        error += "; " + warning;
    return nullptr;
}

std::string LDrawReader::addSurfaces(const std::vector<LDrawPart>& parts, LDrawResolver& resolver)
{
    std::vector<LDrawPart> drawn;
    std::vector<LDrawPart> leftOut;
    for (const LDrawPart& part : parts)
    {
        bool isFound = false;
        if (std::string why = resolver.addSurfaces(part, isFound); !why.empty()) return why;
        (isFound ? drawn : leftOut).push_back(part);
    }
    constexpr const char* WHY = "are inclined or between the studs of the others";
    if (!drawn.empty())
        _warnings.push_back("these parts " + std::string(WHY) +
                            " and are drawn as surfaces: " + join(countByName(drawn)));
    if (!leftOut.empty())
        _warnings.push_back("these parts " + std::string(WHY) + " and are left out: " + join(countByName(leftOut)));
    return {};
}

void LDrawReader::addWarnings(const LDrawBricks& bricks, const LDrawResolver& resolver)
{
    if (!bricks.overlapping.empty())
        _warnings.push_back("these parts overlap others and are left out: " + join(countByName(bricks.overlapping)));
    for (const std::string& why : _library.getErrors())
        _warnings.push_back(why);
    Counts unknown = resolver.getMissing();
    if (std::erase_if(unknown, isBasePlate) > 0)
        _warnings.emplace_back("base plates are left out, since models stand on them without containing them");
    if (!unknown.empty())
        _warnings.push_back("these parts are not known and are left out: " + join(unknown) +
                            (_library.hasParts() ? "" : "; LDRAWDIR may name the folder of a part library"));
    if (!bricks.unknownColors.empty())
        _warnings.push_back("these colours are not known and are shown in grey: " + join(bricks.unknownColors));
}

osg::ref_ptr<osg::Node> LDrawReader::createScene(const LDrawBricks& bricks, const LDrawDocument& document,
                                                 const LDrawResolver& resolver, const LDrawColors& colors) const
{
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->setName(_name);
    if (bricks.model)
    {
        const osg::ref_ptr<osg::Node> lego = createLegoNode(_name, *bricks.model);
        document.getHeader().store(*lego);
        scene->addChild(lego);
    }
    if (!resolver.getTriangles().empty()) scene->addChild(createLDrawGeometry(resolver.getTriangles(), colors));
    return scene;
}

} // namespace osgLego
