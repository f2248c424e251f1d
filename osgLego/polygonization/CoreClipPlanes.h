#pragma once

#include <array>
#include <cstddef>

#include <glm/vec4.hpp>
#include <osg/RenderInfo>
#include <osg/State>

namespace osgLego
{

/** The enabled clip planes of the scene as uniforms, for contexts of the core profile, where GL keeps none. Empty in
 * other contexts.
 *
 * Used while a drawable is drawn, as long as its state stays applied.
 */
class CoreClipPlanes
{
public:
    static constexpr std::size_t MAXIMUM = 8; // GL's minimum of GL_MAX_CLIP_DISTANCES

    /** Find the planes, where the stage that is being drawn positions them. Needs the context current. */
    explicit CoreClipPlanes(osg::RenderInfo& renderInfo);

    bool isEmpty() const { return !_hasPlanes; }

    /** Set the uniforms of the program that a state has applied. Needs its context current. */
    void apply(const osg::State& state) const;

private:
    std::array<glm::vec4, MAXIMUM> _planes{}; // in eye coordinates, by their numbers; GL ignores those not enabled
    bool _hasPlanes = false;
};

} // namespace osgLego
