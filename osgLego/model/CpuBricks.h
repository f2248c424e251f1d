#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/model/ModelBuilder.h>

#include <functional>
#include <string>

#include <osg/ref_ptr>

namespace osgLego
{

/** Options for making bricks on the CPU, and results other than the bricks. */
struct CpuBricksWork
{
    std::function<bool()> isCancelled;                 //!< called from any thread; may be empty
    std::function<void(const LegoProgress&)> progress; //!< may be empty; see ModelBuilder::setProgress()
    PreviousLayout* previous = nullptr; //!< parts to keep where the cells have not changed; replaced by the new ones
    /** The layout that is shown, whose parts a draft keeps, and whose colours cells keep; null: `previous`. */
    const PreviousLayout* shown = nullptr;
    /** Called with parts laid with Effort::INSTANT and without columns, and their layout, before those of the settings
     * are laid; empty: no such draft is made. */
    std::function<void(const BrickModel& draft, PreviousLayout&& layout)> showDraft;
    bool isDraftGreedy = false; //!< whether the layout of the draft is not searched, which takes half as long
    LegoStatistics statistics;  //!< of the bricks, without those of parts
    std::function<LayoutStatistics()> measureLayout; //!< computes the figures of the last parts; empty without parts
    std::string error;   //!< why there are no bricks, in one sentence; empty if it was cancelled
    std::string warning; //!< a setting without effect, to be printed once for a source; may be empty
};

/** The settings of a quick draft of parts: with Effort::INSTANT, neither joined nor supported. */
LegoSettings createDraftSettings(LegoSettings settings);

/** The source of triangles in the first grid that settings give them.
 * @return null, with one sentence in `error`, if cells can't fill it. */
osg::ref_ptr<const LegoSource> createFirstSource(const SceneTriangles& triangles, const LegoSettings& settings,
                                                 std::string& error);

/** Make the bricks of a source: voxelize it, and apply its other settings. May be called from any thread;
 * uses all threads that oneTBB gives the caller.
 * @return null if it was cancelled, or with `work.error`. @throws std::bad_alloc if there is not enough memory. */
osg::ref_ptr<const BrickModel> makeBricksOnCpu(const LegoSource& source, CpuBricksWork& work);

} // namespace osgLego
