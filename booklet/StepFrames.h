#pragma once

#include "ArrowPlacement.h"
#include "BookletBlocks.h"
#include "BookletCamera.h"
#include "BookletFrame.h"
#include "BookletModel.h"

#include <osgLego/BrickModel.h>
#include <osgLego/PlanningOptions.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Which part of the model the picture of each step shows, at which scale, and with which arrows. Pictures are as wide
 * as the finished model, and as high as the parts in place; those of a section may leave out what is far below the
 * parts that it adds, if they become much lower so.
 *
 * Uses no GL. One thread. */
class StepFrames
{
public:
    /** The pictures of a chapter: their scale, and the size of the largest of them in pitches. */
    struct Scale
    {
        double pixels = 0.0; //!< per pitch
        glm::dvec2 size{0.0};
    };

    /** @param model must outlive this object, and so must `plate`, which is null without a base plate.
     * @param front the view of steps without turns. */
    StepFrames(const BookletModel& model, const BrickModel* plate, const BuildingView& front);

    /** Let pictures of the steps of a chapter in some blocks be those of a section, until the next call. Others show
     * all of their chapter's parts in place. */
    void setSection(std::size_t chapter, std::span<const BookletBlock> blocks);

    /** Whether the base plate, if there is one, is below the parts of a chapter: submodels are built beside it. */
    bool isOnPlate(const BookletChapter& chapter) const;
    BookletCamera createCamera(const BookletChapter& chapter, const BookletStep& step) const;
    /** All of the finished chapter. */
    BookletFrame findWhole(const BookletChapter& chapter, const BookletCamera& camera) const;
    /** The part of the picture that a step needs, with its arrows, as wide as all of its chapter's. */
    BookletFrame findFrame(std::size_t chapter, std::size_t step) const;
    /** Whether a picture leaves out the lower part of the model. */
    bool isCut(std::size_t chapter, std::size_t step) const;
    /** The arrows to the submodels that a step attaches, and to its hidden parts, in pitches in the plane of the
     * picture. */
    const ArrowPlacement& findArrows(std::size_t chapter, std::size_t index) const;
    const Scale& getScale(std::size_t chapter) const { return _scales[chapter]; }

private:
    /** A view: the quarter turns, and whether it is upside down. */
    using View = std::pair<int, bool>;
    /** By view, the height in the picture's plane below which pictures show nothing, unless their steps need it. */
    using Cuts = std::map<View, double>;
    using Steps = std::vector<std::size_t>;

    static View getView(const BookletStep& step) { return {step.turns, step.isUpsideDown}; }
    BookletFrame findPlaced(const BookletChapter& chapter, const BookletStep& step, const BookletCamera& camera) const;
    BookletFrame findUncut(std::size_t chapter, std::size_t step) const;
    BookletFrame findCut(std::size_t chapter, std::size_t step, const Cuts& cuts) const;
    Cuts findCuts(std::size_t chapter, const Steps& steps) const;
    double findLowest(std::size_t chapter, std::size_t step) const;
    double sumHeights(std::size_t chapter, const Steps& steps, const Cuts& cuts) const;
    Scale findScale(std::size_t chapter, const Steps& steps) const;

    const BookletModel& _model;
    const BrickModel* _plate;
    BuildingView _front;
    mutable std::map<const BookletStep*, ArrowPlacement> _arrows; // of steps that are known
    std::vector<Cuts> _cuts;                                      // of each chapter; none if all is shown
    std::vector<Scale> _scales;                                   // likewise
    std::vector<Scale> _scalesOfChapters;                         // without sections
};

} // namespace osgLego
