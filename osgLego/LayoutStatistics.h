#pragma once

#include <osgLego/Export.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The means by which a model was made to stand, and to be easier to build (LegoSettings::Parts::support). */
struct SupportStatistics
{
    bool stands = true;                 //!< whether it stands now, without pieces of `numPropped`
    bool isLaidAgain = false;           //!< whether some parts were laid again
    std::size_t numHiddenCells = 0;     //!< cells added inside, where nobody sees them
    std::size_t numColumns = 0;         //!< columns added below the model
    std::size_t numColumnParts = 0;     //!< their parts
    std::size_t numPropped = 0;         //!< pieces that stand on columns of their own alone, not as parts of the model
    std::size_t numBuildingColumns = 0; //!< of `numColumns`, those that make the building plan easier
    /** Parts of the largest submodel of the building plan; 0 if there is none, or if building was not planned: of
     * models that fall, and of large ones. */
    std::size_t largestSubmodel = 0;
    std::size_t deepestSubmodel = 0; //!< how deep its submodels are nested; likewise
    std::size_t numFallingSteps = 0; //!< steps of the plan after which the model has to be held; likewise
    double milliseconds = 0.0;       //!< the time taken
};

/** A piece of a model that nothing joins to the rest. */
struct LoosePiece
{
    std::size_t numParts = 0;
    glm::ivec3 lower{0}; //!< the lowest cell of the grid along each axis
    glm::ivec3 upper{0}; //!< the highest one
};

/** The changes by which the pieces of a model were joined (LegoSettings::Parts::connect). */
struct ConnectionStatistics
{
    std::size_t numPiecesBefore = 1; //!< pieces of the first layout
    std::size_t numPieces = 1;       //!< pieces that are left
    std::size_t numAddedCells = 0;   //!< cells added to join pieces
    std::size_t numRecolored = 0;    //!< cells that got another colour
    std::vector<LoosePiece> loose;   //!< the pieces that are left apart from the largest, the larger ones first
    double milliseconds = 0.0;       //!< the time taken, without that for support
    bool isSupported = false;        //!< whether the changes of SupportStatistics joined pieces, too
};

/** Figures of the parts that cells were joined to (LegoSettings::Parts::set). Times are in milliseconds. */
struct OSGLEGO_EXPORT LayoutStatistics
{
    std::size_t numCells = 0;
    std::size_t numInterior = 0; //!< cells that LegoSettings::Parts::fill added
    std::size_t numParts = 0;
    /** Width, depth and height of the model in millimetres, in real parts with a pitch of 8 mm, without the studs on
     * top. */
    glm::dvec3 size{0.0};
    /** The sum over all layers of the fewest parts that can cover one; unset unless it was asked for. */
    std::optional<std::size_t> lowerBound;
    std::size_t numComponents = 0;         //!< pieces of the model that no stud holds together
    std::size_t numComponentsPossible = 0; //!< the fewest that any layout of these cells can have
    std::size_t numArticulationParts = 0;  //!< parts without which their piece would fall apart
    std::size_t numFloating = 0;           //!< parts in pieces that do not reach the lowest layer
    double stackedSeams = 0.0;      //!< the share of joints in layers that lie on a joint of the layer below, 0 to 1
    std::size_t stackedLength = 0;  //!< the number of those joints, in cell widths
    std::size_t numColors = 0;      //!< different colours of parts
    std::size_t numUnavailable = 0; //!< parts of a size that was never made in their colour
    /** The mean difference (CIEDE2000) between visible cells and the colour of their surface: 1 is just noticeable. */
    double meanColorError = 0.0;
    double maximumColorError = 0.0;                 //!< the largest such difference
    std::optional<ConnectionStatistics> connection; //!< unset unless LegoSettings::Parts::connect or support is on
    std::optional<SupportStatistics> support;       //!< unset unless LegoSettings::Parts::support is on
    double palette = 0.0;                           //!< the time taken to look up colours
    double fill = 0.0;                              //!< likewise to find interior cells
    double layout = 0.0;                            //!< likewise to lay parts
    double figures = 0.0;                           //!< likewise to compute these figures

    /** A report in a few lines of English, without the times. */
    std::string toString() const;
};

} // namespace osgLego
