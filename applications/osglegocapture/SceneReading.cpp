#include "SceneReading.h"

#include "Cancellation.h"
#include "InputFiles.h"
#include "ModelSize.h"

namespace osgLego
{

std::unique_ptr<CaptureScene> readScene(const CaptureOptions& options, const ProgressBar& progress)
{
    warnOfModelSize(options.mesh);
    progress.show("reading");
    std::unique_ptr<CaptureScene> scene;
    {
        const Cancellation::Unasked unasked;
        scene = std::make_unique<CaptureScene>(options);
    }
    progress.warn(scene->getWarning());
    for (const LegoNode* lego : scene->findLegoNodes())
        InputFiles::add(lego->getSettings().getPalette());
    return scene;
}

} // namespace osgLego
