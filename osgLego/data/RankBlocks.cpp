#include <osgLego/data/RankBlocks.h>

#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/BuildingPoints.h>

#include <cstddef>

#include <glm/vec3.hpp>

namespace osgLego
{

std::vector<std::uint32_t> createRankBlocks(const BrickModel& model, std::span<const std::uint32_t> ranks)
{
    constexpr int SIDE = BrickPoints::BLOCK_SIDE;
    const auto placeOf = [](const glm::ivec3& place, const glm::ivec3& size)
    { return static_cast<std::size_t>(place.x + size.x * (place.y + size.y * place.z)); };
    const glm::ivec3 numBlocks = (model.getGrid().dimensions + SIDE - 1) / SIDE;
    std::vector<std::uint32_t> words(placeOf({0, 0, numBlocks.z}, numBlocks));
    for (std::size_t index = 0; index < model.getBricks().size(); ++index)
    {
        const glm::ivec3 cell = model.getBricks()[index].getCell();
        const std::size_t block = placeOf(cell / SIDE, numBlocks);
        if (words[block] == 0)
        {
            words[block] = static_cast<std::uint32_t>(words.size());
            words.resize(words.size() + placeOf({0, 0, SIDE}, glm::ivec3(SIDE)), CellRanks::NEVER);
        }
        const std::size_t part = model.getParts().empty() ? index : model.getPartIndices()[index];
        words[words[block] + placeOf(cell % SIDE, glm::ivec3(SIDE))] = ranks[part];
    }
    return words;
}

} // namespace osgLego
