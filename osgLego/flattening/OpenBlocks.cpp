#include <osgLego/flattening/OpenBlocks.h>

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

OpenBlocks::OpenBlocks(const glm::ivec3& size)
{
    constexpr float MOST = 32.0f;
    _width = std::max(static_cast<float>(std::max(size.x, std::max(size.y, size.z))) / MOST, 1.0f);
    _counts = glm::max(glm::ivec3(glm::ceil(glm::vec3(size) / _width)), 1);
    const glm::ivec3 all = _counts + 2;
    _states.resize(static_cast<std::size_t>(all.x) * static_cast<std::size_t>(all.y) * static_cast<std::size_t>(all.z));
}

void OpenBlocks::cover(const glm::vec3& place)
{
    _states[indexOf(blockAt(place))] = State::COVERED;
}

void OpenBlocks::findOpen()
{
    constexpr std::array<glm::ivec3, 6> NEIGHBORS{glm::ivec3(1, 0, 0),  glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
                                                  glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1),  glm::ivec3(0, 0, -1)};
    std::vector<glm::ivec3> blocks{glm::ivec3(-1)};
    _states[indexOf(blocks.back())] = State::OPEN;
    while (!blocks.empty())
    {
        const glm::ivec3 block = blocks.back();
        blocks.pop_back();
        for (const glm::ivec3& step : NEIGHBORS)
        {
            const glm::ivec3 neighbor = block + step;
            if (glm::any(glm::lessThan(neighbor, glm::ivec3(-1))) || glm::any(glm::greaterThan(neighbor, _counts)))
                continue;
            State& state = _states[indexOf(neighbor)];
            if (state != State::EMPTY) continue;
            state = State::OPEN;
            blocks.push_back(neighbor);
        }
    }
}

bool OpenBlocks::isBesideOpen(const glm::vec3& place) const
{
    const glm::ivec3 block = blockAt(place);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (_states[indexOf(block + glm::ivec3(x, y, z))] == State::OPEN) return true;
    return false;
}

glm::ivec3 OpenBlocks::blockAt(const glm::vec3& place) const
{
    return glm::clamp(glm::ivec3(place / _width), glm::ivec3(0), _counts - 1);
}

std::size_t OpenBlocks::indexOf(const glm::ivec3& block) const
{
    const glm::ivec3 all = _counts + 2;
    return static_cast<std::size_t>(block.x + 1 + all.x * (block.y + 1 + all.y * (block.z + 1)));
}

} // namespace osgLego
