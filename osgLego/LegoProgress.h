#pragma once

namespace osgLego
{

/** The progress of making bricks on the CPU; see LegoNode::getProgress(). Aligned to its size, so that processors load
 * and store it at once. */
struct alignas(8) LegoProgress
{
    enum class Stage
    {
        IDLE,       //!< no bricks are being made
        CELLS,      //!< cells are being found and filled
        PARTS,      //!< parts are being laid
        CONNECTION, //!< pieces are being joined
        SUPPORT     //!< the model is being made to stand
    };

    Stage stage = Stage::IDLE;
    float fraction = 0.0f; //!< of the stage, 0 to 1; 0 in the stages IDLE and CELLS
};

} // namespace osgLego
