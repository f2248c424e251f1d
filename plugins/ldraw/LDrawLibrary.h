#pragma once

#include "LDrawDocument.h"
#include "LDrawFolders.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace osgLego
{

/** The files that a document may refer to: those in its own folder, and those of LDraw's part library. Each file is
 * read once. One thread. */
class LDrawLibrary
{
public:
    /** Without any files. */
    LDrawLibrary() = default;
    /** @param modelFolder the folder of the document; empty: the current one.
     * @param libraryFolder that of the library, with the folders parts, p and models in it; empty if there is none. */
    LDrawLibrary(const std::string& modelFolder, const std::string& libraryFolder);

    /** Whether there is a library. */
    bool hasParts() const { return _hasParts; }
    /** A file by its normalized name; null if there is none, or if it can't be read. */
    const LDrawDocument* find(const std::string& name);
    /** The definitions of colours in the library's LDConfig.ldr. */
    std::vector<LDrawColorDefinition> readColors();
    /** For each file or folder that can't be read, one sentence that names it. */
    const std::vector<std::string>& getErrors() const { return _errors; }

private:
    std::unique_ptr<LDrawDocument> read(const std::string& name);

    LDrawFolders _lookup;
    std::vector<std::string> _folders;
    std::string _libraryFolder;
    bool _hasParts = false;
    std::map<std::string, std::unique_ptr<LDrawDocument>> _documents;
    std::vector<std::string> _errors;
};

} // namespace osgLego
