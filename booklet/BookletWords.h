#pragma once

#include "BookletModel.h"

#include <osgLego/PlanningOptions.h>

#include <ostream>
#include <string>
#include <vector>

namespace osgLego
{

/** Writes building instructions in words, for readers who listen or use braille: each part with its place in studs and
 * with its neighbours, so that the model can be built from the text alone. One thread. */
class BookletWords
{
public:
    /** @param model must outlive this object. @param view the side of the model that is nearest to it is the front. */
    explicit BookletWords(const BookletModel& model, const BuildingView& view = {});

    /** Write only some steps of the main model. @param first counted from 0. @param end behind the last one. */
    void setSteps(std::size_t first, std::size_t end);

    /** @param title of the model. */
    void write(std::ostream& stream, const std::string& title);

private:
    /** A part of a chapter: its columns from the left, its rows from the front and its layers from the bottom,
     * beginning with 1, and its description. */
    struct Place
    {
        std::string name; // such as "A2.1", the first part of step A2
        std::string type; // such as "red brick 2 x 4"
        glm::ivec3 first{1};
        glm::ivec3 last{1};
    };

    /** The names of parts in place that new parts touch. */
    struct Neighbors
    {
        std::vector<std::string> below;
        std::vector<std::string> above;
        const Place* first = nullptr; // of all of them; null if there are none
    };

    std::vector<Place> findPlaces(std::size_t chapter) const;
    std::vector<std::string> findNames(std::size_t chapter) const;
    std::vector<std::string> findNamesOfCopy(const BookletChapter& copy) const;
    void writeIntroduction(const std::string& title);
    void writeBasePlate(const BasePlate& plate, const glm::ivec2& size);
    void writeChapter(std::size_t chapter);
    void writeStep(const BookletChapter& chapter, const BookletStep& step, const std::vector<Place>& places);
    void writePart(const std::vector<Place>& places, std::size_t part, bool isUpsideDown, bool isOnPlate);
    void writeSubmodel(std::size_t submodel, const std::vector<Place>& places, std::size_t first, bool isUpsideDown,
                       bool isOnPlate);
    Neighbors findNeighbors(const std::vector<Place>& places, std::size_t first, std::size_t end) const;
    std::string formatNeighbors(const Neighbors& neighbors, int layer, bool isUpsideDown, bool isOnPlate) const;

    const BookletModel& _model;
    int _turns; // quarter turns of the model, 0 to 3, counter-clockwise from above, that bring its front to the reader
    int _layerHeight; // in cells
    std::size_t _firstStep = 0;
    std::size_t _endStep;
    std::ostream* _stream = nullptr;
};

} // namespace osgLego
