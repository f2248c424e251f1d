#include <osgLego/stability/ContactFinder.h>

#include <osgLego/PartType.h>

#include <algorithm>

namespace osgLego
{

namespace
{

/** Finds the parts beside and above a part, by its cells. */
class ContactFinder
{
public:
    explicit ContactFinder(const BrickModel& model) : _model(model), _up(model.getGrid().getUpIndex()) {}

    void find(std::uint32_t part, std::vector<Contact>& contacts)
    {
        findBeyond(part, 0, Contact::SIDE_X, contacts);
        findBeyond(part, 3 - _up, Contact::SIDE_Y, contacts);
        findBeyond(part, _up, Contact::STUDS, contacts);
    }

private:
    /** Find the parts beyond the face of a part at the upper end of an axis of the grid. */
    void findBeyond(std::uint32_t part, int axis, Contact::Kind kind, std::vector<Contact>& contacts)
    {
        const glm::ivec3 low = _model.getParts()[part].getCell();
        const glm::ivec3 size = _model.getParts()[part].getSize();
        const int other = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        _found.clear();
        glm::ivec3 cell = low;
        cell[axis] += size[axis];
        for (cell[other] = low[other]; cell[other] < low[other] + size[other]; ++cell[other])
            for (cell[third] = low[third]; cell[third] < low[third] + size[third]; ++cell[third])
                if (const Part* beyond = _model.findPart(cell))
                    _found.push_back(static_cast<std::uint32_t>(beyond - _model.getParts().data()));
        std::sort(_found.begin(), _found.end());
        _found.erase(std::unique(_found.begin(), _found.end()), _found.end());
        for (const std::uint32_t beyond : _found)
            contacts.push_back({part, beyond, kind});
    }

    const BrickModel& _model;
    const int _up;
    std::vector<std::uint32_t> _found;
};

} // namespace

std::vector<PartBox> findPartBoxes(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    const int up = grid.getUpIndex();
    const int plates = getCellPlates(grid);
    std::vector<PartBox> boxes;
    boxes.reserve(model.getParts().size());
    for (const Part& part : model.getParts())
    {
        const auto toBox = [&](const glm::ivec3& cell) { return glm::ivec3(cell.x, cell[3 - up], cell[up] * plates); };
        const PartType* type = findPartType(part, grid);
        boxes.push_back({toBox(part.getCell()), toBox(part.getCell() + part.getSize()), type ? type->mass : 0.0});
    }
    return boxes;
}

std::vector<Contact> findContacts(const BrickModel& model)
{
    ContactFinder finder(model);
    std::vector<Contact> contacts;
    for (std::uint32_t part = 0; part < model.getParts().size(); ++part)
        finder.find(part, contacts);
    return contacts;
}

} // namespace osgLego
