#include "LDrawWriter.h"

#include "LDrawColors.h"
#include "LDrawFrame.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <tuple>

#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

// LDraw's specification demands it.
constexpr const char* END_OF_LINE = "\r\n";

void append(std::string& line, double number)
{
    // Far below the precision of real parts, and above the rounding errors of transforms.
    constexpr double STEPS = 1e9;
    number = std::round(number * STEPS) / STEPS;
    if (number == 0.0) number = 0.0; // without a sign
    std::array<char, 64> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    line.append(text.data(), result.ptr);
    line += ' ';
}

std::string formatColor(const Part& part)
{
    if (part.colorCode != Part::NO_CODE) return std::to_string(part.colorCode);
    std::array<char, 16> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), LDrawColors::toDirect(part.color), 16);
    return "0x" + std::string(text.data(), result.ptr);
}

void writeReference(std::ostream& stream, const std::string& color, const LDrawTransform& transform,
                    std::string_view name)
{
    std::string line = "1 " + color + " ";
    for (int axis = 0; axis < 3; ++axis)
        append(line, transform.place[axis]);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            append(line, transform.axes[column][row]);
    stream << line << name << END_OF_LINE;
}

/** A model's parts in the order of building: layer by layer. */
std::vector<Part> sortByLayer(const BrickModel& model, const LDrawFrame& frame)
{
    std::vector<Part> parts = model.getParts();
    const auto keyOf = [&frame](const Part& part)
    {
        const LatticeBox box = frame.toBox(part);
        return std::tuple(box.place.z, box.place.y, box.place.x);
    };
    std::sort(parts.begin(), parts.end(),
              [&keyOf](const Part& part, const Part& other) { return keyOf(part) < keyOf(other); });
    return parts;
}

/** Write the parts of a model, with a step after each layer. */
void writeParts(std::ostream& stream, const BrickModel& model, const LDrawTransform& transform)
{
    const LDrawFrame frame(model);
    const std::vector<Part> parts = sortByLayer(model, frame);
    for (std::size_t index = 0; index < parts.size(); ++index)
    {
        const Part& part = parts[index];
        const PartType* type = findPartType(part, model.getGrid());
        writeReference(stream, formatColor(part), transform * frame.getTransform(part),
                       std::string(type->number) + ".dat");
        const bool isLast = index + 1 == parts.size();
        if (isLast || frame.toBox(part).place.z != frame.toBox(parts[index + 1]).place.z)
            stream << "0 STEP" << END_OF_LINE;
    }
}

/** A text for one line of a header. */
std::string toLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
    return text;
}

/** The title of a file. The words before it keep it from being a command such as NOFILE, whatever the text is. */
std::string toTitle(const std::string& text)
{
    constexpr std::size_t LONGEST = 200; // readers limit lines
    std::string title = "Model: " + toLine(text);
    if (title.size() <= LONGEST) return title;
    std::size_t end = LONGEST;
    while ((static_cast<unsigned char>(title[end]) & 0xc0) == 0x80) // inside a character of UTF-8
        --end;
    return title.substr(0, end);
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

LDrawWriter::LDrawWriter(const LDrawScene& scene, const std::string& fileName) :
    _scene(scene), _stem(toLine(osgDB::getStrippedName(fileName))),
    _extension(osgDB::getLowerCaseFileExtension(fileName))
{
}

std::string LDrawWriter::nameOf(std::size_t model) const
{
    return _stem + "-" + std::to_string(model + 1) + ".ldr";
}

void LDrawWriter::write(std::ostream& stream) const
{
    if (_extension == "mpd")
    {
        writeMainOfMany(stream);
        return;
    }
    writeHeader(stream, _stem + "." + _extension, _scene.models.front());
    for (const LDrawPlacement& placement : _scene.placements)
        writeParts(stream, *_scene.models[placement.model].bricks, placement.transform);
}

void LDrawWriter::writeMainOfMany(std::ostream& stream) const
{
    const std::string main = _stem + ".ldr";
    stream << "0 FILE " << main << END_OF_LINE;
    writeHeader(stream, main, _scene.models.front());
    for (const LDrawPlacement& placement : _scene.placements)
        writeReference(stream, std::to_string(LDrawDocument::MAIN_COLOR), placement.transform, nameOf(placement.model));
    stream << "0 STEP" << END_OF_LINE;
    for (std::size_t model = 0; model < _scene.models.size(); ++model)
    {
        stream << "0 FILE " << nameOf(model) << END_OF_LINE;
        writeHeader(stream, nameOf(model), _scene.models[model]);
        writeParts(stream, *_scene.models[model].bricks, {});
    }
}

void LDrawWriter::writeHeader(std::ostream& stream, const std::string& name, const LDrawModel& model) const
{
    stream << "0 " << toTitle(model.title.empty() ? _stem : model.title) << END_OF_LINE;
    stream << "0 Name: " << name << END_OF_LINE;
    stream << "0 Author: osgLego" << END_OF_LINE;
    stream << "0 !LDRAW_ORG Model" << END_OF_LINE;
    // The more restrictive of the two licences in LDraw's specification: the author may choose the other one.
    stream << "0 !LICENSE Not redistributable : see NonCAreadme.txt" << END_OF_LINE;
    stream << "0 // Settings of osgLego: " << toLine(model.settings) << END_OF_LINE << END_OF_LINE;
}

std::string LDrawWriter::check(std::string_view text) const
{
    std::string error;
    const std::optional<LDrawDocument> document = LDrawDocument::parse(text, error);
    if (!document) return error;
    LDrawLibrary library({}, {});
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
    return rest.empty() ? std::string() : "the file, read back, has more parts than the model";
}

} // namespace osgLego
