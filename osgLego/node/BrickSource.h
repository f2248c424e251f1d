#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/node/SourceWatch.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Decides which bricks a LegoNode has: those of its source, flattened again after changes of the source or of the
 * settings, or stored bricks.
 *
 * Every function may be called from any thread as long as no other thread changes the source.
 */
class BrickSource
{
public:
    /** The revisions of stored bricks. */
    struct StoredRevisions
    {
        std::uint64_t own = 0;    //!< in their own colours
        std::uint64_t byLoad = 0; //!< in colours for the load on their joints; 0 if the settings don't ask for them
    };

    /** @return whether stored bricks must be shown again, because their colours change. */
    bool setSettings(const LegoSettings& settings, const SettingsPalette& palette);
    /** The settings, apart from their progress, which the store keeps. */
    LegoSettings getSettings() const;
    SettingsPalette getPalette() const;
    void setTiming(bool timing);
    bool getTiming() const;
    void setReadBack(bool readBack);
    bool getReadBack() const;

    /** Flatten the source at the next look, even if its signature has not changed. */
    void dirty()
    {
        _isContentDirty = true;
        _isDirty = true;
    }
    bool isDirty() const { return _isDirty; }

    /** Use bricks instead of those of the source; null: look at the source again.
     * @return false if they are already used. */
    bool setStored(const BrickModel* bricks);
    osg::ref_ptr<const BrickModel> getStored() const;
    /** Number stored bricks that are to be shown. The parts have their own colours until those for their load have been
     * computed. */
    StoredRevisions numberStored(const BrickModel& bricks);

    /** Check the source, and flatten it if it has changed since the last check. Does nothing if there are stored
     * bricks. @return whether it was flattened. */
    bool look(const osg::Node& node);

    /** The revision of the bricks to show: those stored, or else those of the source; 0 if there are none. */
    std::uint64_t getRevision() const;
    /** The revision of the last look or of the last stored bricks, even if there is nothing to show. */
    std::uint64_t getLastRevision() const;
    /** The source of the last look; null if it has no visible triangles, or if there is an obstacle or stored bricks.
     */
    osg::ref_ptr<const LegoSource> getSource() const;
    /** The transform from the coordinates of the bricks to those of the node: the identity, except for bricks of a
     * source in a lattice of the world. */
    osg::Matrixd getToNode() const;
    /** The reason why a source with triangles can't be legolized; empty if there is none. */
    std::string getObstacle() const;
    /** Print the obstacle, once for each. */
    void warnOfObstacle();

private:
    mutable std::mutex _mutex;
    SourceWatch::Request _request;
    SourceWatch _watch;
    osg::ref_ptr<const BrickModel> _stored;
    std::string _printedObstacle;
    std::atomic<bool> _isDirty{true};
    std::atomic<bool> _isContentDirty{false}; // whether the source has changed in a way that is not detected
};

} // namespace osgLego
