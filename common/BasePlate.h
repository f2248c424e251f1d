#pragma once

#include <common/PartsList.h>
#include <osgLego/BrickModel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** The studded base plate below a model: the smallest that it fits on, or, for larger models, the fewest, and of those
 * the smallest. It is not part of the model.
 *
 *     const BasePlate plate(*model);
 *     list.addExtra(plate.createRow());
 *
 * Uses no GL. Immutable; every function may be called from any thread. */
class BasePlate
{
public:
    static constexpr std::int32_t COLOR_CODE = 2; //!< of LDraw; green

    /** @param model with at least one part. */
    explicit BasePlate(const BrickModel& model);

    /** Whether a number of LDraw is that of a base plate of any size. */
    static bool isNumber(std::string_view number);

    /** Such as "Base plate 16 x 32". @param sign of multiplication, with the spaces around it. */
    std::string getName(const std::string& sign = " x ") const;
    /** The number of LDraw and BrickLink, such as "3857". */
    const std::string& getNumber() const { return _number; }
    std::size_t getQuantity() const;
    /** The plates in a list of parts. */
    PartsList::Extra createRow() const;
    /** How many of its studs are to the left of the model, and how many in front of it. */
    const glm::ivec2& getMargin() const { return _margin; }

    /** One plate, in studs along x and the other horizontal axis. */
    const glm::ivec2& getPlateSize() const { return _size; }
    /** The number of plates along x and the other horizontal axis. */
    const glm::ivec2& getCounts() const { return _counts; }
    /** All plates together, in studs along x and the other horizontal axis. */
    glm::ivec2 getSize() const { return _size * _counts; }

    /** The plates in their place below the model, in another grid. @param isFaded whether it shows new parts above it.
     */
    osg::ref_ptr<const BrickModel> createModel(bool isFaded) const;

private:
    void choose(const glm::ivec2& footprint);

    std::string _number;
    glm::ivec2 _size{0};   // in studs, along x and the other horizontal axis
    glm::ivec2 _counts{1}; // plates beside each other
    glm::ivec2 _margin{0};
    BrickGrid _grid;
};

} // namespace osgLego
