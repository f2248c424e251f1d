#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoNode.h>
#include <osgLego/PlanningOptions.h>
#include <osgLego/Stability.h>
#include <osgLegoBooklet/Export.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace osgLego
{

/** The content of a booklet, and how its making is followed. */
struct BookletOptions
{
    /** The steps of the main model to write, counted from 1. */
    struct StepRange
    {
        std::size_t first = 1;
        std::size_t last = 1; //!< may be beyond the last step of the model
    };

    /** The surface on which the model stands while it is built. */
    BuildingBase base = BuildingBase::TABLE;
    /** The front of the booklet: the view of the cover, and of steps before any quarter turn. */
    BuildingView view;
    std::optional<StepRange> steps; //!< unset: all steps
    /** The stability of the node's bricks on `base`, if it is known already; it is computed otherwise. */
    std::optional<StabilityReport> stability;
    /** The order in which the node's bricks are built, if it is planned already: on `base`, for `view`, with checks of
     * stability, as DesignCandidate::plan. Null, or a plan for another number of parts: it is planned. */
    osg::ref_ptr<const BuildingPlan> plan;
    /** Of the booklet and its model. Empty: the node's user value "title", as nodes read from LDraw's files have;
     * without it, the readable name of the file, such as "Small Tower". */
    std::string title;
    /** Likewise. Empty: the user value "author"; without it, there is none on the cover, and osgLego in the model. */
    std::string author;
    /** Of the model in LDraw's format, the text after !LICENSE. Empty: the user value "license"; without it, no line.
     */
    std::string license;
    /** Whether the files that readers can save from the page, the model and the parts lists, are written beside it,
     * too.
     */
    bool writesDownloads = false;
    /** How messages name the model, such as "'tower.mpd'". */
    std::string modelName = "the model";
    /** Called regularly, from any thread; the booklet is not written if it returns true. May be empty. */
    std::function<bool()> isCancelled;
    /** Called with the fraction done, 0 to 1, and the name of the work that comes next, in the calling thread. May be
     * empty. */
    std::function<void(double share, const std::string& work)> progress;
};

/** The reason why a booklet was not written. */
struct BookletError
{
    enum class Reason
    {
        BAD_MODEL, //!< there are no parts, or not of the shapes of bricks and plates, or the palette can't be read
        BAD_VIEW,  //!< BookletOptions::view has an elevation outside the range of BuildingView
        BAD_STEPS, //!< BookletOptions::steps has no step of the model
        NO_PLUGIN, //!< the plugin osgdb_ldraw was not found
        NO_GL,     //!< the context can't draw bricks
        BAD_FILE,  //!< the file can't be written
        CANCELLED  //!< BookletOptions::isCancelled has returned true
    };

    Reason reason = Reason::BAD_MODEL;
    std::string message; //!< one sentence, with the value and what was expected
};

/** Check whether writeBooklet() can write a file, as far as that is known without a model: its folder, and the plugin
 * osgdb_ldraw, with which booklets offer the model in LDraw's format. Call it before computations that take long, such
 * as that of a layout. A folder that does not exist yet is created, and removed again.
 * @return nothing if it can. */
OSGLEGOBOOKLET_EXPORT std::optional<BookletError> checkBookletFile(const std::string& fileName);

/** Write a booklet of building instructions: one HTML page that needs no other file, and beside it the same
 * instructions in words, as a text file. docs/instructions.md describes both.
 *
 * The names of the files that readers can save from it follow from the name of its file, and so does the title unless
 * one is given or the node has one.
 * The file is written atomically, and its folder is created if only the folder is missing; if the function fails, an
 * older file is unchanged and a new folder is removed.
 *
 * Preconditions:
 * 1. The node has parts (LegoSettings::Parts::set), or its stored bricks have; those that it does not have yet are made
 *    first.
 * 2. The context is realized, and provides OpenGL 4.0 or later, compatibility profile. It is current in no thread, nor
 *    used by another one during the call. Afterwards it can be used again.
 * 3. osgDB finds the plugin osgdb_ldraw: it is installed, or OSG_LIBRARY_PATH names the folder that contains the folder
 *    osgPlugins-3.6.5 with it.
 *
 * Usage:
 *
 *     osgLego::BookletOptions options;
 *     options.progress = [](double share, const std::string& work) { showProgress(share, work); };
 *     const std::string file = "booklets/bunny.html";
 *     std::optional<osgLego::BookletError> error = osgLego::checkBookletFile(file);
 *     if (!error) error = osgLego::writeBooklet(*lego, file, *context, options);
 *     if (error) std::cerr << error->message << std::endl;
 *
 * A model of 500 parts takes about a minute and a half on two cores; above 5,000 parts, steps are planned without
 * computing whether the model stands after each of them. The node is not changed, and must not be changed during the
 * call. May be called from any thread.
 * @return nothing if the booklet is written. @throws std::bad_alloc if there is not enough memory. */
OSGLEGOBOOKLET_EXPORT std::optional<BookletError> writeBooklet(const LegoNode& lego, const std::string& fileName,
                                                               osg::GraphicsContext& context,
                                                               const BookletOptions& options = {});

/** The name of a booklet, without a folder and an extension, for the file name of a model, which may end with the
 * settings of a pseudo-loader: "bunny" for "models/bunny.ply.64.legolize". */
OSGLEGOBOOKLET_EXPORT std::string nameBooklet(const std::string& modelFileName);

/** The base plates below a model, as booklets of BuildingBase::PLATE show them: a model of one layer of green parts, in
 * the coordinates of the given one. Uses no GL; may be called from any thread.
 * @param model with at least one part. */
OSGLEGOBOOKLET_EXPORT osg::ref_ptr<const BrickModel> createBasePlate(const BrickModel& model);

} // namespace osgLego
