#pragma once

#include "SubmodelTurn.h"

#include <common/BasePlate.h>
#include <common/PartsList.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** Parts of one type and colour that are needed together. */
struct BookletItem
{
    std::size_t kind = 0; //!< an index into BookletModel::getKinds()
    std::size_t quantity = 0;
};

/** A step as it is printed. */
struct BookletStep
{
    std::string name;                 //!< such as "12", or "A3" in a submodel
    std::vector<BookletItem> items;   //!< the parts it adds, without those of submodels, in the order of kinds
    std::vector<BookletItem> pressed; //!< of these, those that parts in place hold from above, and nothing from below
    std::vector<BookletItem> joined;  //!< likewise, those that only others of this step hold from above
    std::vector<std::size_t>
        submodels;             //!< chapters that are built before this step and attached in it, copies included
    int turns = 0;             //!< as BuildingStep::turns
    bool isUpsideDown = false; //!< as BuildingStep::isFromBelow
    bool isTurned = false;     //!< whether the view differs from that of the step before; at first, from the front
    bool isTurnedOver = false; //!< whether it does so because the submodel is turned upside down
    bool stands = true;        //!< as BuildingStep::stands
    std::size_t numUnheld = 0; //!< the parts of this step that nothing holds, those of submodels included
    std::size_t numPieces = 0; //!< after this step, without unheld parts; a base plate joins those that stand on it
    std::size_t numPlaced = 0; //!< the parts in place after this step, those of submodels included
    std::size_t numDirect = 0; //!< the parts that this step puts in place, without those of submodels; they come first
    std::size_t numNew = 0;    //!< the parts that this step puts in place, those of submodels included

    /** Whether parts fall after this step, other than those that nothing holds anyway. */
    bool falls() const { return !stands && numUnheld == 0; }
    /** Whether the arrows to its submodels have their letters: if there are several, or other parts, to which arrows
     * may point, too. */
    bool hasLetters() const { return submodels.size() > 1 || (submodels.size() == 1 && numDirect > 0); }
};

/** The steps of the main model, or of a submodel. */
struct BookletChapter
{
    static constexpr std::size_t MOST_LISTED = 200; //!< parts; those of larger submodels are in several bags

    /** Whether it is a submodel that is built from a box within the step that attaches it. */
    bool isCallout() const { return isSubmodel && model->getParts().size() <= BuildingPlan::MOST_PARTS_HELD; }
    /** Whether the contents of a submodel list its parts. */
    bool isListed() const { return model->getParts().size() <= MOST_LISTED; }

    bool isSubmodel = false; //!< whether it is not the main model

    std::string letter; //!< of a submodel, such as "A"; empty for the main model
    std::size_t original =
        0;                //!< the equal submodel of the same step that is built first, turned or not, or this chapter
    std::size_t copy = 1; //!< which one of those that are equal in the same step, from 1
    std::size_t quantity = 1;              //!< of an original: how many are equal, itself included
    SubmodelTurn turn;                     //!< of a copy, from its original
    osg::ref_ptr<const BrickModel> model;  //!< of the parts of this chapter, those of submodels included
    osg::ref_ptr<const BuildingPlan> plan; //!< of that model, with one step for each of `steps`, and no submodels
    std::vector<BookletItem> items;        //!< all parts, those of submodels included, in the order of kinds
    std::vector<BookletStep> steps;
};

/** The content of a booklet, without its pictures: kinds of parts, and steps by chapter.
 *
 *     const BookletModel booklet(*model, *plan, palette->getColors());
 *     for (const BookletStep& step : booklet.getMainChapter().steps) ...
 *
 * Uses no GL. Immutable; every function may be called from any thread.
 */
class BookletModel
{
public:
    /** @param model with parts that are in getPartTypes(), at least one.
     * @param plan of the model.
     * @param palette the colours that the model was built in, as in PartsList::add().
     * @param base the surface on which the model stands. */
    BookletModel(const BrickModel& model, const BuildingPlan& plan, std::span<const PaletteColor> palette,
                 BuildingBase base = BuildingBase::TABLE);

    /** The base plate, which is not counted among the parts; nothing on a table. */
    const std::optional<BasePlate>& getBasePlate() const { return _basePlate; }

    const PartsList& getPartsList() const { return _list; }
    /** The rows of the parts list. */
    const std::vector<PartsList::Row>& getKinds() const { return _kinds; }
    /** The main model, and then the submodels in the order of the plan. */
    const std::vector<BookletChapter>& getChapters() const { return _chapters; }
    const BookletChapter& getMainChapter() const { return _chapters.front(); }
    /** The submodels of a step without the copies of others, in the order in which they are built: those in boxes last.
     */
    std::vector<std::size_t> getOriginals(const BookletStep& step) const;

    std::size_t getNumParts() const;
    /** The number of steps of the main model, which are numbered without letters. */
    std::size_t getNumSteps() const { return getMainChapter().steps.size(); }
    std::size_t getNumStepsOfSubmodels() const;
    /** The number of pieces that no stud holds together. */
    std::size_t getNumPieces() const { return _numPieces; }
    double getMass() const; //!< grams
    /** The width, depth and height, without the studs on top, in millimetres. */
    glm::dvec3 getSize() const;
    /** The number of parts that nothing holds when they are placed. */
    std::size_t getNumUnheld() const { return _numUnheld; }
    /** The names of the steps, also of submodels that are not callouts, after which parts fall, without steps that
     * place unheld parts. */
    std::vector<std::string> getFallingSteps() const;

private:
    void addBasePlate(const BrickModel& model);
    BookletChapter createChapter(const BuildingPlan& plan, const std::vector<BuildingStep>& steps,
                                 BuildingBase base) const;
    std::vector<BookletItem> countKinds(const std::vector<std::uint32_t>& parts) const;
    void findCopies(const BookletStep& step);
    std::optional<SubmodelTurn> findTurn(const BookletChapter& chapter, const BookletChapter& other) const;
    void nameSteps(BookletChapter& chapter, std::size_t& numNamed);

    osg::ref_ptr<const BrickModel> _model;
    PartsList _list;
    std::vector<PartsList::Row> _kinds;
    std::vector<std::size_t> _kindOfPart;
    std::vector<BookletChapter> _chapters;
    std::optional<BasePlate> _basePlate;
    std::size_t _numPieces = 0;
    std::size_t _numUnheld = 0;
};

} // namespace osgLego
