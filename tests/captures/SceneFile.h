#pragma once

#include <osglegocapture/CaptureOptions.h>

#include <string>
#include <vector>

namespace osgLego::test
{

/** A line of a file of scenes: `NAME MESH OPTIONS...`, with the options of osglegocapture, and `--aliased` for one
 * sample per pixel. */
struct SceneLine
{
    std::string name;
    std::string mesh; //!< `sample`, `bunny`, or `@` and the name of a scene of SceneLibrary
    std::vector<std::string> options;
};

/** Read all lines except those that are empty or begin with `#`. Throws CaptureError. */
std::vector<SceneLine> readSceneFile(const std::string& fileName);

/** Read the options of a line as osglegocapture does. Throws CaptureError.
 * @param folder the folder of the scene file, which also contains its probes. */
CaptureOptions toCaptureOptions(const SceneLine& line, const std::string& folder, const std::string& output);

/** Whether the mesh of a line is available: the bunny may not have been fetched. */
bool hasMesh(const SceneLine& line);

} // namespace osgLego::test
