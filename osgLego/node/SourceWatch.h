#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/flattening/SourceSignature.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Notices when a source has changed, and flattens it then.
 *
 * Not locked: one thread at a time, while no other thread changes the source.
 */
class SourceWatch
{
public:
    /** What a source is to be legolized by. */
    struct Wishes
    {
        LegoSettings settings;
        bool timing = false;
        bool readBack = false;
    };

    /** Look at a source, and flatten it if it, or the wishes, are not those of the last look.
     * @param isDirty flatten it all the same.
     * @return whether it was flattened. */
    bool look(const osg::Node& node, const Wishes& wishes, bool isDirty);

    /** The source of the last look; null when it shows no triangles. */
    osg::ref_ptr<const LegoSource> getSource() const { return _source; }

private:
    SourceSignature _signature;
    SourceSignatures _signatures;
    SurfaceTextureCache _textures;
    osg::ref_ptr<const LegoSource> _source;
};

} // namespace osgLego
