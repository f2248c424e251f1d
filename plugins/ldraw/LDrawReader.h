#pragma once

#include "LDrawBricks.h"

#include <string>
#include <vector>

#include <osg/Node>

namespace osgLego
{

/** Turns a document into a scene: a LegoNode with the parts of known types as stored bricks, below an
 * AmbientOcclusionScene, and surfaces of other parts beside it.
 *
 * Uses no GL. One thread. */
class LDrawReader
{
public:
    /** @param name that of the file, for messages and nodes. The library must outlive this object. */
    LDrawReader(std::string name, LDrawLibrary& library) : _name(std::move(name)), _library(library) {}

    /** @return null, with one sentence in `error`, if the text is not LDraw or nothing of it can be shown. */
    osg::ref_ptr<osg::Node> read(const std::string& text, std::string& error);

    /** For each kind of content that was left out or changed, one sentence. */
    const std::vector<std::string>& getWarnings() const { return _warnings; }

private:
    osg::ref_ptr<osg::Node> createScene(const LDrawBricks& bricks, const LDrawDocument& document,
                                        const LDrawResolver& resolver, const LDrawColors& colors) const;
    std::string addSurfaces(const std::vector<LDrawPart>& parts, LDrawResolver& resolver);
    void addWarnings(const LDrawBricks& bricks, const LDrawResolver& resolver);

    std::string _name;
    LDrawLibrary& _library;
    std::vector<std::string> _warnings;
};

} // namespace osgLego
