#pragma once

#include "CaptureOptions.h"
#include "ProgressBar.h"

#include <common/JsonValue.h>
#include <osgLego/BrickModel.h>
#include <osgLego/Stability.h>

#include <optional>
#include <string>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Whether the parts of a scene stand. Each model stands by itself, on its own lowest layer. */
class SceneStability
{
public:
    /** Throws CaptureError if it is cancelled, and if loads are on no part or could be on several.
     * @param models at least one, each with parts.
     * @param options their base, loads and tilt.
     * @param progress tells how long the work has taken. */
    SceneStability(const std::vector<osg::ref_ptr<const BrickModel>>& models, const CaptureOptions& options,
                   const ProgressBar& progress);

    /** The report on the only model; nothing if there are several. */
    std::optional<StabilityReport> getReport() const;
    /** A report in a few lines: the verdict, the weakest joint, and the first parts that fall. */
    std::string toText() const;
    /** All figures; docs/osglegocapture.md describes them. */
    JsonValue toJson() const;

private:
    struct ModelStability
    {
        osg::ref_ptr<const BrickModel> model;
        StabilityReport report;
        std::size_t numPieces; // that nothing joins
    };

    /** The model with the least margin. */
    const ModelStability& getWorst() const;

    BuildingBase _base;
    std::vector<AddedWeight> _weights; // on the parts of the only model
    std::vector<ModelStability> _models;
};

} // namespace osgLego
