#pragma once

#include <osglegocapture/CaptureOptions.h>

#include <string>
#include <vector>

namespace osgLego::test
{

/** A line of a file of scenes: `NAME MESH OPTIONS...`, the options being osglegocapture's own. */
struct SceneLine
{
    std::string name;
    std::string mesh; //!< `sample`, `bunny`, or `@` and the name of a scene of SceneLibrary
    std::vector<std::string> options;
};

/** Read all lines but those that are empty or begin with `#`. Throws CaptureError. */
std::vector<SceneLine> readSceneFile(const std::string& fileName);

/** Let osglegocapture's own reader read a line's options. Throws CaptureError.
 * @param folder that of the file of scenes, which its probes lie beside. */
CaptureOptions toCaptureOptions(const SceneLine& line, const std::string& folder, const std::string& output);

/** Whether the mesh of a line can be had: the bunny may not have been fetched. */
bool hasMesh(const SceneLine& line);

} // namespace osgLego::test
