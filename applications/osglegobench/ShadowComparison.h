#pragma once

#include "BenchScene.h"

#include <common/JsonValue.h>

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** What to draw with shadows. */
struct ShadowOptions
{
    std::string technique;       //!< one of getShadowTechniques()
    unsigned int numFrames = 20; //!< of each kind
    glm::ivec2 size{1280, 720};  //!< of the picture, in pixels
};

/** The names of the classes of osgShadow that bricks support. */
std::vector<std::string> getShadowTechniques();

/** Compare frames without shadows, frames with the shadows of a technique, and frames in which the technique's cameras
 * have a colour buffer too, so that bricks are shaded for the shadow map. Draws the three in turns.
 * @return a row of figures. Throws std::runtime_error. */
JsonValue compareShadows(const BenchScene& scene, const ShadowOptions& options);

/** Print the rows as a table. */
void printShadows(const JsonValue& document);

} // namespace osgLego
