#include "LDrawWriter.h"

#include "LDrawColors.h"
#include "LDrawFrame.h"
#include "LDrawParser.h"
#include "LDrawSteps.h"
#include "LDrawText.h"

#include <common/BasePlate.h>
#include <common/ReadableName.h>
#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

/** A text for one line of a header. */
std::string toLine(const std::string& text)
{
    return replaceControlCharacters(text);
}

/** The title of a file. */
std::string toTitle(const std::string& text)
{
    constexpr std::size_t LONGEST = 200; // readers limit lines
    std::string title = std::string(LDrawDocument::TITLE_PREFIX) + " " + toLine(text);
    if (title.size() <= LONGEST) return title;
    std::size_t end = LONGEST;
    while ((static_cast<unsigned char>(title[end]) & 0xc0) == 0x80) // inside a character of UTF-8
        --end;
    return std::string(trimmed(std::string_view(title).substr(0, end))); // readers trim lines, too
}

/** The cells of a part and the number of its colour, for comparisons. */
using PartKey = std::array<std::int32_t, 7>;

PartKey toKey(const LatticeBox& box, std::int32_t color)
{
    return {box.place.z, box.place.y, box.place.x, box.size.x, box.size.y, box.size.z, color};
}

std::vector<PartKey> keysOf(const BrickModel& model)
{
    const LDrawFrame frame(model);
    std::vector<PartKey> keys;
    keys.reserve(model.getParts().size());
    for (const Part& part : model.getParts())
        keys.push_back(toKey(frame.toBox(part),
                             part.colorCode != Part::NO_CODE ? part.colorCode : LDrawColors::toDirect(part.color)));
    std::sort(keys.begin(), keys.end());
    return keys;
}

/** The keys of parts that were read; without those that are in no cells. */
std::vector<PartKey> keysOf(const std::vector<LDrawPart>& parts)
{
    const LDrawLattice lattice = LDrawLattice::find(parts);
    std::vector<std::pair<LatticeBox, std::int32_t>> boxes;
    for (const LDrawPart& part : parts)
        if (const std::optional<LatticeBox> box = lattice.toBox(part)) boxes.emplace_back(*box, part.color);
    glm::ivec3 lowest = boxes.empty() ? glm::ivec3(0) : boxes.front().first.place;
    for (const auto& [box, color] : boxes)
        lowest = glm::min(lowest, box.place);
    std::vector<PartKey> keys;
    keys.reserve(boxes.size());
    for (auto& [box, color] : boxes)
    {
        box.place -= lowest;
        keys.push_back(toKey(box, color));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

} // namespace

LDrawWriter::LDrawWriter(const LDrawScene& scene, const std::string& fileName, LDrawWriteOptions options) :
    _scene(scene), _options(std::move(options)), _stem(toLine(osgDB::getStrippedName(fileName))),
    _extension(osgDB::getLowerCaseFileExtension(fileName))
{
}

std::string LDrawWriter::nameOf(std::size_t model) const
{
    return _stem + "-" + std::to_string(model + 1);
}

void LDrawWriter::write(std::ostream& stream) const
{
    if (_extension != "mpd")
    {
        writeHeader(stream, _stem + "." + _extension, createSharedHeader(), _scene.models.front().settings);
        for (const LDrawPlacement& placement : _scene.placements)
            LDrawSteps(_scene.models[placement.model], _stem, _options.isOnPlate)
                .writeParts(stream, placement.transform);
        return;
    }
    if (_scene.placements.size() == 1)
        writeModel(stream, _scene.models.front(), _stem);
    else
        writeMainOfMany(stream);
}

/** Write the file of a model and those of its submodels. */
void LDrawWriter::writeModel(std::ostream& stream, const LDrawModel& model, const std::string& stem) const
{
    LDrawSteps steps(model, stem, _options.isOnPlate);
    ModelHeader header = createHeader(model.header, model.name);
    stream << "0 FILE " << stem << ".ldr" << LDRAW_END_OF_LINE;
    writeHeader(stream, stem + ".ldr", header, model.settings);
    steps.writeMain(stream);
    const std::string title = header.title;
    for (const std::uint32_t submodel : steps.getSubmodels())
    {
        stream << "0 FILE " << steps.getName(submodel) << LDRAW_END_OF_LINE;
        header.title = title + ", " + steps.getName(submodel);
        writeHeader(stream, steps.getName(submodel), header, model.settings);
        steps.writeSubmodel(stream, submodel);
    }
}

void LDrawWriter::writeMainOfMany(std::ostream& stream) const
{
    const std::string main = _stem + ".ldr";
    stream << "0 FILE " << main << LDRAW_END_OF_LINE;
    writeHeader(stream, main, createSharedHeader(), _scene.models.front().settings);
    for (const LDrawPlacement& placement : _scene.placements)
        writeReference(stream, std::to_string(LDrawDocument::MAIN_COLOR), placement.transform,
                       nameOf(placement.model) + ".ldr");
    stream << "0 STEP" << LDRAW_END_OF_LINE;
    for (std::size_t model = 0; model < _scene.models.size(); ++model)
        writeModel(stream, _scene.models[model], nameOf(model));
}

/** The header of a file with all models: of their texts, those that they share. */
ModelHeader LDrawWriter::createSharedHeader() const
{
    const LDrawModel& first = _scene.models.front();
    ModelHeader shared = first.header;
    for (const LDrawModel& model : _scene.models)
        shared.keepEqual(model.header);
    return createHeader(shared, _scene.models.size() == 1 ? first.name : std::string());
}

/** The header of a file.
 * @param texts those of models, which the given ones replace.
 * @param name of the model, for the title; empty: that of the file. */
ModelHeader LDrawWriter::createHeader(const ModelHeader& texts, const std::string& name) const
{
    ModelHeader header = _options.header;
    header.complete(texts);
    header.complete({toReadableName(name.empty() ? _stem + "." + _extension : name),
                     std::string(LDrawDocument::DEFAULT_AUTHOR),
                     {}});
    return header;
}

void LDrawWriter::writeHeader(std::ostream& stream, const std::string& name, const ModelHeader& header,
                              const std::string& settings) const
{
    stream << "0 " << toTitle(header.title) << LDRAW_END_OF_LINE;
    stream << "0 Name: " << name << LDRAW_END_OF_LINE;
    stream << "0 Author: " << toLine(header.author) << LDRAW_END_OF_LINE;
    stream << "0 !LDRAW_ORG Model" << LDRAW_END_OF_LINE;
    // Only the author of a model can grant rights, or refuse them.
    if (!header.license.empty()) stream << "0 !LICENSE " << toLine(header.license) << LDRAW_END_OF_LINE;
    stream << "0 // Settings of osgLego: " << toLine(settings) << LDRAW_END_OF_LINE << LDRAW_END_OF_LINE;
}

std::string LDrawWriter::check(std::string_view text) const
{
    std::string error;
    const std::optional<LDrawDocument> document = LDrawParser::parse(text, error);
    if (!document) return error;
    LDrawLibrary library; // a file in the current folder would replace a base plate
    LDrawResolver resolver(*document, library);
    error = resolver.resolve();
    if (!error.empty()) return error;
    // The parts of each placement follow each other.
    std::span<const LDrawPart> rest = resolver.getParts();
    for (const LDrawPlacement& placement : _scene.placements)
    {
        const std::vector<PartKey> expected = keysOf(*_scene.models[placement.model].bricks);
        const auto own = rest.first(std::min(rest.size(), expected.size()));
        rest = rest.subspan(own.size());
        const LDrawTransform inverse = placement.transform.getInverse();
        std::vector<LDrawPart> parts(own.begin(), own.end());
        for (LDrawPart& part : parts)
            part.transform = inverse * part.transform;
        if (keysOf(parts) != expected) return "the file, read back, has other parts than the model";
    }
    if (!rest.empty()) return "the file, read back, has more parts than the model";
    return resolver.getMissing() == countBasePlates() ? std::string() : "the file, read back, has other base plates";
}

/** The number of base plates by the names of their files. */
std::map<std::string, std::size_t> LDrawWriter::countBasePlates() const
{
    std::map<std::string, std::size_t> counts;
    if (!_options.isOnPlate) return counts;
    for (const LDrawPlacement& placement : _scene.placements)
    {
        const BasePlate plates(*_scene.models[placement.model].bricks);
        counts[toPartFile(plates.getNumber())] += plates.getQuantity();
    }
    return counts;
}

} // namespace osgLego
