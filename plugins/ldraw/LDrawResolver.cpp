#include "LDrawResolver.h"

#include "LDrawText.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

namespace osgLego
{

namespace
{

/** The type of a part with a normalized name; null if it is not one of the known types. */
const PartType* findTypeOf(const std::string& name)
{
    static const std::unordered_map<std::string_view, const PartType*> types = []
    {
        std::unordered_map<std::string_view, const PartType*> result;
        for (const PartType& type : getPartTypes())
            result[type.number] = &type;
        return result;
    }();
    const auto found = types.find(toPartNumber(name));
    return found == types.end() ? nullptr : found->second;
}

std::int32_t inherit(std::int32_t color, std::int32_t outer)
{
    return color == LDrawDocument::MAIN_COLOR || color == LDrawDocument::EDGE_COLOR ? outer : color;
}

/** Whether nested transforms lead too far away, or to values that are not numbers. */
bool isTooFar(const LDrawTransform& transform)
{
    const auto isWithin = [](const glm::dvec3& vector)
    {
        // Written so that NaN is too far.
        return std::abs(vector.x) <= LDrawResolver::FARTHEST && std::abs(vector.y) <= LDrawResolver::FARTHEST &&
               std::abs(vector.z) <= LDrawResolver::FARTHEST;
    };
    const glm::dmat3& axes = transform.axes;
    return !isWithin(transform.place) || !isWithin(axes[0]) || !isWithin(axes[1]) || !isWithin(axes[2]);
}

std::string describeTooManyLines()
{
    return "its submodels add up to more than " + std::to_string(LDrawResolver::MOST_LINES) + " lines; expected fewer";
}

} // namespace

std::string LDrawResolver::resolve()
{
    // Before parts take memory: a few kilobytes of submodels within submodels can add up to any number of lines.
    if (countAll(_document, _document.getMain()) > MOST_LINES) return describeTooManyLines();
    return visit({_document, _document.getMain(), {}, LDrawDocument::MAIN_COLOR});
}

std::string LDrawResolver::addSurfaces(const LDrawPart& part, bool& isFound)
{
    const LDrawDocument* document = _library.find(toPartFile(part.type->number));
    isFound = document != nullptr;
    return document ? visit({*document, document->getMain(), part.transform, part.color}) : std::string();
}

std::string LDrawResolver::visit(const Visit& visit)
{
    if (std::find(_open.begin(), _open.end(), &visit.file) != _open.end())
        return "'" + visit.file.name + "' includes itself";
    if (_open.size() >= DEEPEST)
        return "files include each other more than " + std::to_string(DEEPEST) + " deep; expected fewer levels";
    if (std::string why = countLines(visit.file.triangles.size()); !why.empty()) return why;
    _open.push_back(&visit.file);
    addTriangles(visit);
    for (const LDrawReference& reference : visit.file.references)
        if (std::string why = visitReference(visit, reference); !why.empty()) return why;
    _open.pop_back();
    return {};
}

std::string LDrawResolver::visitReference(const Visit& visit, const LDrawReference& reference)
{
    if (std::string why = countLines(1); !why.empty()) return why;
    const std::string& name = visit.document.getName(reference);
    const LDrawTransform transform = visit.transform * reference.transform;
    if (isTooFar(transform)) return "'" + name + "' is too far away or too large; expected at most 1e+09 LDU";
    const std::int32_t color = inherit(reference.color, visit.color);
    if (const PartType* type = findTypeOf(name))
    {
        _parts.push_back({type, transform, color});
        return {};
    }
    return visitFile({visit.document, visit.file, transform, color}, name);
}

/** Visit a file that is referred to from another one, of which `outer` has the document. */
std::string LDrawResolver::visitFile(const Visit& outer, const std::string& name)
{
    if (const LDrawFile* file = outer.document.find(name))
        return visit({outer.document, *file, outer.transform, outer.color});
    if (const LDrawDocument* document = _library.find(name))
        return visit({*document, document->getMain(), outer.transform, outer.color});
    ++_missing[name];
    return {};
}

void LDrawResolver::addTriangles(const Visit& visit)
{
    for (const LDrawTriangle& triangle : visit.file.triangles)
    {
        LDrawTriangle& added = _triangles.emplace_back(triangle);
        added.color = inherit(triangle.color, visit.color);
        for (glm::dvec3& corner : added.corners)
            corner = visit.transform * corner;
    }
}

std::string LDrawResolver::countLines(std::size_t lines)
{
    _numLines += lines;
    if (_numLines <= MOST_LINES) return {};
    return describeTooManyLines();
}

/** The lines of a file and of all that it includes, each as often as it is included; at least MOST_LINES + 1 if there
 * are more. */
std::size_t LDrawResolver::countAll(const LDrawDocument& document, const LDrawFile& file)
{
    const auto [place, isNew] = _counts.try_emplace(&file, 0); // which is also that of a file that includes itself
    if (!isNew || _open.size() >= DEEPEST) return place->second;
    _open.push_back(&file);
    std::size_t count = file.triangles.size();
    for (const LDrawReference& reference : file.references)
        if (count <= MOST_LINES) count += 1 + countReferred(document, document.getName(reference));
    _open.pop_back();
    return _counts[&file] = count;
}

/** The result of countAll() for a name; 0 if there is no file to visit. */
std::size_t LDrawResolver::countReferred(const LDrawDocument& document, const std::string& name)
{
    if (findTypeOf(name)) return 0;
    if (const LDrawFile* file = document.find(name)) return countAll(document, *file);
    const LDrawDocument* other = _library.find(name);
    return other ? countAll(*other, other->getMain()) : 0;
}

} // namespace osgLego
