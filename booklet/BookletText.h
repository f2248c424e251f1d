#pragma once

#include "BookletModel.h"

#include <common/PartsList.h>

#include <cstddef>
#include <string>
#include <vector>

namespace osgLego
{

/** The name of a type, such as "Brick 2 x 4", with a multiplication sign, and without spaces at which lines break. */
std::string nameType(const PartType& type);

/** BrickLink's name of a colour; empty without a number of BrickLink. */
std::string nameBrickLinkColor(const PaletteColor& color);

/** The name of a colour with the spelling of BrickLink: "Dark Bluish Gray" for "Dark Bluish Grey". */
std::string spellGray(std::string name);

/** Parts of one kind within a sentence, such as "2 red bricks 2 x 4". */
std::string describeParts(const PartsList::Row& row, std::size_t quantity);

/** The main model or a submodel, such as "model", without an article. */
std::string nameBuilt(const BookletChapter& chapter);

/** A sentence that says whether the builder must hold something after a step of a chapter; empty otherwise, and in
 * callouts, which a hand holds. */
std::string describeHold(const BookletChapter& chapter, const BookletStep& step);

/** A sentence that says until when pieces lie apart, and how to place them, for the first step after which they do;
 * empty for others, and if the next step joins the pieces. @param step of the chapter. @param advice the end of the
 * sentence. */
std::string describePieces(const BookletChapter& chapter, const BookletStep& step, const std::string& advice);

/** Sentences on what a picture of a step does not show: parts that are joined with others before they are placed, or
 * pressed on from below, pieces that lie apart, and whether the builder must hold something afterwards. Empty if there
 * is nothing to say. */
std::string describeNotes(const BookletModel& model, const BookletChapter& chapter, const BookletStep& step);

/** The numbers of parts and submodels that a step adds, such as "4 parts + A". */
std::string describeCount(const BookletModel& model, const BookletStep& step);

/** Join words, as in "a, b and c". */
std::string joinWords(const std::vector<std::string>& words);

} // namespace osgLego
