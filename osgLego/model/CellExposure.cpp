#include <osgLego/model/CellExposure.h>

namespace osgLego
{

namespace
{

/** The weight of a direction downwards: models are seldom looked at from below. */
constexpr double DOWNWARDS = 0.25;

} // namespace

CellExposure::CellExposure(const LayoutProblem& problem) : _size(problem.size), _isCovered(problem.size)
{
    for (const LayoutCell& cell : problem.cells)
        _isCovered.edit({cell.place[0], cell.place[1], cell.place[2]}) = true;
}

bool CellExposure::isInside(const glm::ivec3& cell) const
{
    return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < _size.x && cell.y < _size.y && cell.z < _size.z;
}

double CellExposure::get(const glm::ivec3& cell) const
{
    double open = 0.0;
    double all = 0.0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
            {
                const glm::ivec3 step(x, y, z);
                if (step == glm::ivec3(0)) continue;
                const double weight = z < 0 ? DOWNWARDS : 1.0;
                all += weight;
                glm::ivec3 next = cell + step;
                while (isInside(next) && !_isCovered.get(next))
                    next += step;
                if (!isInside(next)) open += weight;
            }
    return open / all;
}

} // namespace osgLego
