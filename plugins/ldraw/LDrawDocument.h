#pragma once

#include "LDrawTransform.h"

#include <common/ModelHeader.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace osgLego
{

/** A line of type 1: a part or a submodel in its place. */
struct LDrawReference
{
    std::int32_t color = 0;
    std::uint32_t name = 0; //!< an index for LDrawDocument::getName()
    LDrawTransform transform;
};

/** A line of type 3, or half of one of type 4. */
struct LDrawTriangle
{
    std::int32_t color = 0;
    std::array<glm::dvec3, 3> corners{};
};

/** One of the files that a document consists of. */
struct LDrawFile
{
    std::string name; //!< normalized; empty in a document without `0 FILE`
    std::vector<LDrawReference> references;
    std::vector<LDrawTriangle> triangles;
};

/** A colour that a document defines by `0 !COLOUR`. */
struct LDrawColorDefinition
{
    std::int32_t code = 0;
    std::array<std::uint8_t, 3> color{}; //!< red, green, blue
};

/** The content of a .ldr, .mpd or .dat file: the lines that place parts or have surfaces, and the title, the
 * author and the licence. Lines of edges, steps and other comments are ignored.
 *
 * A plain value without GL; every function may be called from any thread.
 */
class LDrawDocument
{
public:
    static constexpr std::int32_t MAIN_COLOR = 16; //!< the colour of the reference to a file
    static constexpr std::int32_t EDGE_COLOR = 24;
    static constexpr std::size_t LONGEST_LINE = 65536;
    static constexpr double LARGEST_NUMBER = 1e7;
    /** Before the titles that LDrawWriter writes: no text after it is a command such as NOFILE. */
    static constexpr std::string_view TITLE_PREFIX = "Model:";
    static constexpr std::string_view DEFAULT_AUTHOR = "osgLego"; //!< of written models without another one

    /** Give the main model a name, if it has none. */
    void setDefaultName(const std::string& name);

    /** The name of a part or a submodel as it is compared: in lower case, with slashes, and without the folder of
     * LDraw's library. */
    static std::string normalizeName(std::string_view name);

    /** The model that the document shows. */
    const LDrawFile& getMain() const { return _files.front(); }
    /** A file by its normalized name; null if the document does not contain it. */
    const LDrawFile* find(const std::string& name) const;
    /** The normalized name of a reference. */
    const std::string& getName(const LDrawReference& reference) const { return _names[reference.name]; }
    const std::vector<LDrawColorDefinition>& getColors() const { return _colors; }
    /** The texts before the first part of the main model, without those that programs write if nobody has chosen any.
     * No licence if a submodel has another one. */
    const ModelHeader& getHeader() const { return _header; }

private:
    friend class LDrawParser;

    std::vector<LDrawFile> _files;
    std::vector<std::string> _names;
    std::vector<LDrawColorDefinition> _colors;
    ModelHeader _header;
    std::unordered_map<std::string, std::size_t> _filesByName;
};

} // namespace osgLego
