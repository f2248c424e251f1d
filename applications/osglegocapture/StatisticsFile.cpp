#include "StatisticsFile.h"

#include <cmath>
#include <string>

#include <osg/GL>

namespace osgLego
{

namespace
{

template <typename Vector>
JsonValue toJson(const Vector& vector)
{
    return JsonValue::createArray({vector.x, vector.y, vector.z});
}

/** Round to microseconds: further digits are noise. */
double rounded(double milliseconds)
{
    return std::round(1000.0 * milliseconds) / 1000.0;
}

std::string glText(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

JsonValue toJson(const LayoutStatistics& layout)
{
    JsonValue json{{"cells", layout.numCells},
                   {"interior", layout.numInterior},
                   {"parts", layout.numParts},
                   {"millimeters", toJson(layout.size)}};
    if (layout.lowerBound) json["lowerBound"] = *layout.lowerBound;
    json.update({{"components", layout.numComponents},
                 {"componentsPossible", layout.numComponentsPossible},
                 {"articulationParts", layout.numArticulationParts},
                 {"floating", layout.numFloating},
                 {"stackedSeams", layout.stackedSeams},
                 {"stackedLength", layout.stackedLength},
                 {"colors", layout.numColors},
                 {"unavailable", layout.numUnavailable},
                 {"meanColorError", layout.meanColorError},
                 {"maximumColorError", layout.maximumColorError},
                 {"milliseconds",
                  {{"palette", rounded(layout.palette)},
                   {"fill", rounded(layout.fill)},
                   {"layout", rounded(layout.layout)},
                   {"figures", rounded(layout.figures)}}}});
    if (layout.connection)
        json["connection"] = {{"piecesBefore", layout.connection->numPiecesBefore},
                              {"pieces", layout.connection->numPieces},
                              {"addedCells", layout.connection->numAddedCells},
                              {"recoloredCells", layout.connection->numRecolored},
                              {"loose", layout.connection->loose.size()},
                              {"supported", layout.connection->isSupported},
                              {"milliseconds", rounded(layout.connection->milliseconds)}};
    if (layout.support)
        json["support"] = {{"stands", layout.support->stands},
                           {"laidAgain", layout.support->isLaidAgain},
                           {"hiddenCells", layout.support->numHiddenCells},
                           {"columns", layout.support->numColumns},
                           {"columnParts", layout.support->numColumnParts},
                           {"buildingColumns", layout.support->numBuildingColumns},
                           {"largestSubmodel", layout.support->largestSubmodel},
                           {"deepestSubmodel", layout.support->deepestSubmodel},
                           {"fallingSteps", layout.support->numFallingSteps},
                           {"propped", layout.support->numPropped},
                           {"milliseconds", rounded(layout.support->milliseconds)}};
    return json;
}

} // namespace

void writeStatistics(std::ostream& stream, const CaptureStatistics& capture, osg::GraphicsContext& context)
{
    const auto& [scene, picture, layout, stability] = capture;
    context.makeCurrent();
    JsonValue json{
        {"renderer", glText(GL_RENDERER)}, {"version", glText(GL_VERSION)}, {"context", context.className()}};
    JsonValue milliseconds{{"reading", rounded(scene.getReadingTime())}};
    if (const LegoNode* lego = scene.getLegoNode())
    {
        const unsigned int contextID = context.getState()->getContextID();
        const LegoStatistics statistics = lego->getStatistics(contextID);
        const osg::ref_ptr<const BrickModel> model = lego->getBricks(contextID);
        const BrickGrid& grid = model->getGrid();
        json["settings"] = lego->getSettings().toString();
        if (!statistics.isStored) json["device"] = statistics.isFromCpu ? "cpu" : "gpu";
        json["triangles"] = statistics.numTriangles;
        json["passes"] = statistics.numSubdivisionPasses;
        json["fineTriangles"] = statistics.numFineTriangles;
        json["coveredCells"] = model->getBricks().size();
        json["drawnBricks"] = statistics.numDrawnBricks;
        json["grid"] = {{"origin", toJson(grid.origin)},
                        {"cellSize", toJson(grid.cellSize)},
                        {"dimensions", toJson(grid.dimensions)}};
        if (layout) json["layout"] = toJson(*layout);
        milliseconds["flattening"] = rounded(statistics.flattening);
        milliseconds["subdivision"] = rounded(statistics.subdivision);
        milliseconds["voxelization"] = rounded(statistics.voxelization);
        milliseconds["extraction"] = rounded(statistics.extraction);
    }
    if (stability) json["stability"] = stability->toJson();
    milliseconds["drawing"] = rounded(picture.getDrawingTime());
    json["milliseconds"] = milliseconds;
    stream << json.toString(4) << '\n';
}

} // namespace osgLego
