#include <osgLego/flattening/SceneBatch.h>

#include <glm/geometric.hpp>

namespace osgLego
{

SceneVertex midpoint(const SceneVertex& a, const SceneVertex& b)
{
    return {0.5 * (a.position + b.position), 0.5f * (a.coordinate + b.coordinate), 0.5f * (a.color + b.color)};
}

double squaredLength(const SceneVertex& a, const SceneVertex& b)
{
    const glm::dvec3 edge = b.position - a.position;
    return glm::dot(edge, edge);
}

} // namespace osgLego
