#include <osgLego/PartType.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

constexpr std::size_t NUM_SIZES = PART_SIZES.size();

/** The mass of a plate in grams, fitted to weighed plates (StableLego, Liu et al. 2024). */
double massOfPlate(int width, int length)
{
    return 0.10937 * width * length + 0.05671 * (width + length) - 0.02207;
}

std::array<PartType, 2 * NUM_SIZES> createTypes()
{
    constexpr std::array<std::string_view, NUM_SIZES> BRICKS{"3005", "3004", "3622", "3010", "3009", "3008",
                                                             "3003", "3002", "3001", "2456", "3007"};
    constexpr std::array<std::string_view, NUM_SIZES> PLATES{"3024", "3023", "3623", "3710", "3666", "3460",
                                                             "3022", "3021", "3020", "3795", "3034"};
    // Weighed (StableLego).
    constexpr std::array<double, NUM_SIZES> BRICK_MASSES{0.43, 0.81, 1.18, 1.57, 2.28, 3.03,
                                                         1.15, 1.78, 2.16, 3.23, 4.40};
    std::array<PartType, 2 * NUM_SIZES> types;
    for (std::size_t index = 0; index < NUM_SIZES; ++index)
    {
        const auto [width, length] = PART_SIZES[index];
        types[index] = {PartFamily::BRICK, width, length, BRICKS[index], BRICK_MASSES[index]};
        types[NUM_SIZES + index] = {PartFamily::PLATE, width, length, PLATES[index], massOfPlate(width, length)};
    }
    return types;
}

} // namespace

std::string PartType::getName() const
{
    return std::string(family == PartFamily::BRICK ? "Brick " : "Plate ") + std::to_string(width) + " x " +
           std::to_string(length);
}

std::size_t PartType::getSizeIndex() const
{
    const auto place = std::find(PART_SIZES.begin(), PART_SIZES.end(), std::array{width, length});
    return static_cast<std::size_t>(place - PART_SIZES.begin());
}

std::span<const PartType> getPartTypes()
{
    static const auto types = createTypes();
    return types;
}

const PartType* findPartType(PartFamily family, int side, int otherSide)
{
    for (const PartType& type : getPartTypes())
        if (type.family == family && type.width == std::min(side, otherSide) &&
            type.length == std::max(side, otherSide))
            return &type;
    return nullptr;
}

const PartType* findPartType(const Part& part, const BrickGrid& grid)
{
    const glm::ivec3 size = part.getSize();
    const int up = grid.getUpIndex();
    const int plates = size[up] * getCellPlates(grid);
    if (plates != 1 && plates != 3) return nullptr;
    return findPartType(plates == 3 ? PartFamily::BRICK : PartFamily::PLATE, size.x, size[3 - up]);
}

int getCellPlates(const BrickGrid& grid)
{
    const double plates = grid.cellSize[grid.getUpIndex()] / grid.getPitch() / 0.4;
    if (std::abs(plates - 1.0) < 1e-6) return 1;
    return std::abs(plates - 3.0) < 1e-6 ? 3 : 0;
}

} // namespace osgLego
