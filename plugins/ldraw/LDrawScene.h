#pragma once

#include "LDrawTransform.h"

#include <common/ModelHeader.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Palette.h>

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <osg/Node>

namespace osgLego
{

/** The parts of a LegoNode, to be written. */
struct LDrawModel
{
    /** The largest number of parts for which the stability is checked after every step, unless the node has a plan.
     * Larger models would take longer than conversions should. */
    static constexpr std::size_t MOST_CHECKED = 5000;

    osg::ref_ptr<const BrickModel> bricks; //!< joined to parts
    std::string name;                      //!< the node's; may be empty
    ModelHeader header;                    //!< the texts that the node has
    std::string settings;
    osg::ref_ptr<const Palette> palette;   //!< null if any colour was allowed
    osg::ref_ptr<const BuildingPlan> plan; //!< of all parts; that of the node, or one made for it
};

/** A model in its place. */
struct LDrawPlacement
{
    std::size_t model = 0; //!< an index into LDrawScene::models
    /** From LDraw's coordinates of the model, with the origin at the centre of its lowest layer, to those of the first
     * placement's. */
    LDrawTransform transform;
};

/** The visible LegoNodes of a scene, for a file of LDraw. The first of them determines the axes and the scale of the
 * file, so that its studs point upwards under any transforms. */
struct LDrawScene
{
    std::vector<LDrawModel> models;
    std::vector<LDrawPlacement> placements;
    std::vector<std::string> warnings; //!< for each loss, one sentence

    /** @return false, with one sentence in `error`, if there are no bricks, or if parts can't represent them. */
    static bool create(const osg::Node& node, LDrawScene& scene, std::string& error);
};

} // namespace osgLego
