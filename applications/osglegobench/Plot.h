#pragma once

#include "BenchEnvironment.h"

#include <string>
#include <utility>
#include <vector>

namespace osgLego
{

/** Curves over one axis, to be drawn by gnuplot. */
struct Plot
{
    struct Curve
    {
        std::string name;
        std::vector<std::pair<double, double>> points;
        bool isVariant = false; //!< of the curve before: it has the same colour, and is dashed
    };

    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<Curve> curves;

    /** The curve of a name, made if there is none yet. */
    Curve& getCurve(const std::string& name);
};

/** Throws std::runtime_error when there is no gnuplot. */
void checkPlotting();

/** Write FOLDER/NAME.png, axes logarithmic, and its numbers as FOLDER/NAME.csv, each completely or not at all; where
 * it was measured stands in both. Throws std::runtime_error. */
void writePlot(const Plot& plot, const BenchEnvironment& environment, const std::string& folder,
               const std::string& name);

} // namespace osgLego
