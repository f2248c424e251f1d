#pragma once

#include "BenchMeshes.h"
#include "BoundCache.h"

#include <common/JsonValue.h>
#include <osgLego/LegoSettings.h>

#include <optional>
#include <string>

namespace osgLego
{

/** The most that each figure of a layout may be; unset: no goal. */
struct LayoutGoals
{
    std::optional<double> ratio;        //!< of the parts to the bound
    std::optional<double> stacked;      //!< the share of joints on joints
    std::optional<double> milliseconds; //!< from the cells to the model of parts
    std::optional<double> articulation; //!< the share of parts
    std::optional<double> ofPlates;     //!< of the parts to those of a layout of plates alone
};

/** A model whose layout is measured. */
struct LayoutCase
{
    std::string figure; //!< such as "solid"
    MeshSource mesh;
    LegoSettings settings; //!< without a palette, all cells have one colour in which every size exists
    LayoutGoals goals;
};

/** How layouts are measured. */
struct LayoutRuns
{
    unsigned int numRuns = 1;
    double boundSeconds = 60.0; //!< for each connected region of a layer
};

/** Lay a model, and compare it with its bound and its goals. Throws std::runtime_error, also if the layout is wrong. */
JsonValue measureLayout(const LayoutCase& layoutCase, const LayoutRuns& runs, BoundCache& bounds);

} // namespace osgLego
