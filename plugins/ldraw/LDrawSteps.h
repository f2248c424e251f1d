#pragma once

#include "LDrawFrame.h"
#include "LDrawScene.h"

#include <ostream>
#include <string>
#include <vector>

namespace osgLego
{

/** Writes the building steps of a model: lines that place parts and submodels, and the ends of steps.
 *
 * A step ends with `0 STEP`. Where the view changes, `0 ROTSTEP` comes before, for the step that it ends and those that
 * follow. LeoCAD ignores that line and counts only `0 STEP`; other programs count both, and skip steps without parts.
 *
 * One thread.
 */
class LDrawSteps
{
public:
    /** The depth up to which nested submodels become files. Readers limit the depth of files; the content of a deeper
     * submodel is written where it is attached. */
    static constexpr std::size_t DEEPEST = 32;

    /** @param model with a plan; it must outlive this object.
     * @param stem the name of the model's file without its extension, from which the names of submodels are made.
     * @param isOnPlate whether the first step begins with the base plates. */
    LDrawSteps(const LDrawModel& model, std::string stem, bool isOnPlate = false);

    /** Write all steps with every part in its final place.
     * @param transform from the coordinates of the model to those of the file. */
    void writeParts(std::ostream& stream, const LDrawTransform& transform);
    /** Write the main steps, with references to submodels. */
    void writeMain(std::ostream& stream);

    /** The submodels that become files, as indices into BuildingPlan::getSubmodels(). */
    const std::vector<std::uint32_t>& getSubmodels() const { return _submodels; }
    std::string getName(std::uint32_t submodel) const;
    /** Write the steps of a submodel, with the origin at the centre of its lowest layer. */
    void writeSubmodel(std::ostream& stream, std::uint32_t submodel);

private:
    struct View
    {
        int turns = 0;
        bool isFromBelow = false;

        bool operator==(const View&) const = default;
    };

    bool isFile(std::uint32_t submodel) const { return _depths[submodel] <= DEEPEST; }
    std::size_t findDepth(std::uint32_t submodel);
    void findOrigins();
    void writeBasePlate(std::ostream& stream, const LDrawTransform& transform) const;
    void writeSteps(std::ostream& stream, const std::vector<BuildingStep>& steps, const glm::dvec3& origin);
    void writeContent(std::ostream& stream, const BuildingStep& step, const glm::dvec3& origin);
    void writePart(std::ostream& stream, std::uint32_t index, const LDrawTransform& transform);
    void endStep(std::ostream& stream, const BuildingStep& step);

    const LDrawModel& _model;
    std::string _stem;
    bool _isOnPlate;
    LDrawFrame _frame;
    View _view;
    std::vector<std::size_t> _depths; // for each submodel, 1 without others in it; 0 until it is found
    std::vector<std::uint32_t> _submodels;
    std::vector<std::uint32_t> _numbers; // for each submodel, in its name
    std::vector<glm::dvec3> _origins;    // for each submodel
};

/** The end of each line, which LDraw's specification demands. */
inline constexpr const char* LDRAW_END_OF_LINE = "\r\n";

/** Write a line of type 1. */
void writeReference(std::ostream& stream, const std::string& color, const LDrawTransform& transform,
                    std::string_view name);

} // namespace osgLego
