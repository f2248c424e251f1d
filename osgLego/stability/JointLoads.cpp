#include <osgLego/stability/JointLoads.h>

#include <osgLego/StabilityReport.h>

#include <algorithm>

namespace osgLego
{

std::vector<float> findLoads(const EquilibriumProgram& program, std::span<const double> pulls)
{
    std::vector<float> loads(program.getNumBodies(), 0.0f);
    for (std::size_t index = 0; index < pulls.size(); ++index)
        for (const std::int32_t body : {program.getJoints()[index].lower, program.getJoints()[index].upper})
        {
            if (body == EquilibriumProgram::NO_BODY) continue;
            float& load = loads[static_cast<std::size_t>(body)];
            load = std::max(load, static_cast<float>(pulls[index] / StabilityReport::CAPACITY));
        }
    return loads;
}

} // namespace osgLego
