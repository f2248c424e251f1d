#pragma once

#include "LDrawLibrary.h"

#include <osgLego/PartType.h>

#include <map>
#include <unordered_map>

namespace osgLego
{

/** A part of a known type in its place. */
struct LDrawPart
{
    const PartType* type = nullptr;
    LDrawTransform transform; //!< to the coordinates of the main model
    std::int32_t color = LDrawDocument::MAIN_COLOR;
};

/** Follows the references of a document to its parts, and to the surfaces of files that are not parts of known types.
 *
 * Functions that return a string return an error message in one sentence; empty on success. One thread.
 */
class LDrawResolver
{
public:
    static constexpr std::size_t DEEPEST = 64;            //!< files within files
    static constexpr double FARTHEST = 1e9;               //!< of a part from the origin, in LDU
    static constexpr std::size_t MOST_LINES = 10'000'000; //!< references and triangles

    /** @param document and library must outlive this object. */
    LDrawResolver(const LDrawDocument& document, LDrawLibrary& library) : _document(document), _library(library) {}

    /** Find all parts and surfaces of the main model. */
    std::string resolve();
    /** Add the surfaces of a part of a known type, if the library contains its file.
     * @param isFound is set to whether it does. */
    std::string addSurfaces(const LDrawPart& part, bool& isFound);

    const std::vector<LDrawPart>& getParts() const { return _parts; }
    /** In the coordinates of the main model, with their final colours. */
    const std::vector<LDrawTriangle>& getTriangles() const { return _triangles; }
    /** The number of references to each name for which there is no file. */
    const std::map<std::string, std::size_t>& getMissing() const { return _missing; }

private:
    /** A file, the document that it belongs to, and its place. */
    struct Visit
    {
        const LDrawDocument& document;
        const LDrawFile& file;
        LDrawTransform transform;
        std::int32_t color = LDrawDocument::MAIN_COLOR;
    };

    std::string visit(const Visit& visit);
    std::string visitReference(const Visit& visit, const LDrawReference& reference);
    std::string visitFile(const Visit& outer, const std::string& name);
    void addTriangles(const Visit& visit);
    std::string countLines(std::size_t lines);
    std::size_t countAll(const LDrawDocument& document, const LDrawFile& file);
    std::size_t countReferred(const LDrawDocument& document, const std::string& name);

    const LDrawDocument& _document;
    LDrawLibrary& _library;
    std::vector<LDrawPart> _parts;
    std::vector<LDrawTriangle> _triangles;
    std::map<std::string, std::size_t> _missing;
    std::vector<const LDrawFile*> _open; // the files that are being visited
    std::size_t _numLines = 0;
    std::unordered_map<const LDrawFile*, std::size_t> _counts; // of countAll()
};

} // namespace osgLego
