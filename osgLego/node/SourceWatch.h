#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/flattening/KeptLattice.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/flattening/SourceSignature.h>
#include <osgLego/flattening/SurfaceTextureCache.h>
#include <osgLego/node/NodePlace.h>

#include <cstdint>
#include <string>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Detects changes of a source, and flattens it when it has changed.
 *
 * Not locked: one thread at a time, while no other thread changes the source.
 */
class SourceWatch
{
public:
    /** The options with which a source is legolized. */
    struct Request
    {
        LegoSettings settings;
        SettingsPalette palette; //!< of the settings
        bool timing = false;
        bool readBack = false;
    };

    /** Whether a source must be flattened even if its signature has not changed. */
    enum class Need
    {
        NONE,
        REQUEST, //!< the request has changed
        CONTENT  //!< the source has changed in a way that its signature may not show
    };

    /** Check a source, and flatten it if it has changed since the last check, or has moved in the world that its bricks
     * belong to. Watches of equal sources share their triangles, if grids are fitted to them.
     * @return whether it was flattened. */
    bool look(const osg::Node& node, const Request& request, Need need);

    /** Forget the source, because other bricks are shown instead.
     * @return the revision of these bricks. */
    std::uint64_t drop();

    /** Forget the source, because an exception has ended look(). @param obstacle the reason. */
    void fail(const std::string& obstacle);

    /** The number of the last source, of its absence, or of the bricks shown instead;
     * higher after every change. */
    std::uint64_t getRevision() const { return _revision; }

    /** The source of the last check; null if it has no visible triangles, or if there is an obstacle, and after drop().
     */
    osg::ref_ptr<const LegoSource> getSource() const { return _source; }

    /** The reason why a source with triangles can't be legolized; empty if there is none. */
    const std::string& getObstacle() const { return _obstacle; }

    /** The transform from the coordinates of the bricks to those of the node; see NodePlace. */
    const osg::Matrixd& getToNode() const { return _place.getToNode(); }

private:
    osg::ref_ptr<const GridTriangles> flatten(const osg::Node& node, LegoSettings& settings);

    NodePlace _place;
    KeptLattice _lattice;
    const osg::Node* _root = nullptr; // for which the lattice was found; compared only
    SourceSignature _signature;
    SourceSignatures _signatures;
    SurfaceTextureCache _textures;
    bool _hasTexts = false; // in the last look
    std::uint64_t _revision = 0;
    osg::ref_ptr<const LegoSource> _source;
    std::string _obstacle;
    bool _isUnique = false; // whether the signature may not show how the source differs from others
};

} // namespace osgLego
