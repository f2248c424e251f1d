#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/model/ModelBuilder.h>

#include <functional>
#include <string>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks of a source and everything else that was found while they were made. Producers of equal sources share
 * them, so that a hundred nodes with the same mesh have it legolized once.
 *
 * Immutable once it is shared; every function may be called from any thread.
 */
struct MadeBricks : public osg::Referenced
{
    osg::ref_ptr<const BrickModel> model;
    LegoStatistics statistics; //!< of the bricks, without those of parts
    std::function<LayoutStatistics()> measureLayout;
    std::string warning; //!< a setting without effect; may be empty
    PreviousLayout layout;

    /** The bricks that another producer has made of the same triangles with the same settings; null if none has them
     * still. */
    static osg::ref_ptr<const MadeBricks> find(const LegoSource& source);
    /** Share bricks of a source, which must depend on nothing else, for as long as a producer refers to them.
     * @return these, or those that another thread has shared meanwhile. */
    static osg::ref_ptr<const MadeBricks> share(const LegoSource& source, const MadeBricks& bricks);

private:
    ~MadeBricks() override = default;
};

} // namespace osgLego
