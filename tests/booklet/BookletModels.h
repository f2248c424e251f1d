#pragma once

#include <booklet/BookletModel.h>
#include <osgLego/BuildingPlan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego::test
{

inline constexpr std::array<std::uint8_t, 3> RED{180, 0, 0};
inline constexpr std::array<std::uint8_t, 3> BLUE{30, 90, 168};

/** A step that places parts and attaches submodels, seen from the front. */
BuildingStep createStep(std::vector<std::uint32_t> parts, std::vector<std::uint32_t> submodels = {});

/** The variations of a tower. */
struct TowerSetting
{
    std::vector<std::size_t> fallingSteps{}; //!< of the model
    std::vector<std::uint32_t> unheldParts{};
    int turnsOfLastStep = 0;
    BuildingBase base = BuildingBase::TABLE;
    bool isInnerUpsideDown = false; //!< whether the inner submodel is built upside down
    bool hasTwoSubmodels = false; //!< whether the second step attaches the inner submodel itself, beside the outer one
};

/** The booklet of six bricks: two red ones of 2x4 on the ground, parts 0 and 1; on them a blue and a red one of 2x4,
 * parts 2 and 3; and above them a blue one of 2x4 and a red one of 1x1, parts 4 and 5.
 *
 * The first step places parts 0 and 1. The second attaches submodel A, which consists of part 2 and of submodel B,
 * part 3. The third places parts 4 and 5. */
BookletModel createTower(const TowerSetting& setting = {});

/** The booklet of a red brick 2x8 on which step 2 attaches two equal submodels, each a blue brick 2x2 on a red one, and
 * step 3 one of five red bricks 2x2 that are placed one by one.
 * @param largeFalls whether the latter does not stand after its second step.
 * @param largeIsOneStep whether its bricks are placed at once instead. */
BookletModel createTwins(bool largeFalls = false, bool largeIsOneStep = false);

} // namespace osgLego::test
