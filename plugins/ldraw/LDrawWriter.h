#pragma once

#include "LDrawScene.h"
#include "LDrawWriteOptions.h"

#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

namespace osgLego
{

/** Writes the models of a scene in LDraw's format, in the order of building. One thread. */
class LDrawWriter
{
public:
    /** @param scene must outlive this object.
     * @param fileName with the extension ldr, a file in which every part is in its final place, or mpd, in which the
     * submodels of a building plan are separate files, and so are models if there are several. */
    LDrawWriter(const LDrawScene& scene, const std::string& fileName, LDrawWriteOptions options = {});

    void write(std::ostream& stream) const;

    /** Whether a text that write() has written, or the file with it, contains all parts, each in its cells and colour.
     * @return one sentence on the first difference; empty if there is none. */
    std::string check(std::string_view text) const;

private:
    void writeModel(std::ostream& stream, const LDrawModel& model, const std::string& stem) const;
    void writeMainOfMany(std::ostream& stream) const;
    void writeHeader(std::ostream& stream, const std::string& name, const ModelHeader& header,
                     const std::string& settings) const;
    ModelHeader createSharedHeader() const;
    ModelHeader createHeader(const ModelHeader& texts, const std::string& name) const;
    std::map<std::string, std::size_t> countBasePlates() const;
    std::string nameOf(std::size_t model) const;

    const LDrawScene& _scene;
    LDrawWriteOptions _options;
    std::string _stem;
    std::string _extension;
};

} // namespace osgLego
