// Pages tiles in by .legolize file names, and prints how long frames take meanwhile.

#include <offscreen/OffscreenContext.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/PagedLOD>
#include <osg/ShapeDrawable>
#include <osgDB/WriteFile>
#include <osgViewer/Viewer>

int main()
{
    constexpr int SIZE = 256; // pixels
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = osgLego::createOffscreenContext(SIZE, SIZE, error);
    const std::string tile = (std::filesystem::temp_directory_path() / "osglego-tile.osgb").string();
    const osg::ref_ptr<osg::Node> sphere = new osg::ShapeDrawable(new osg::Sphere);
    if (!context || !osgDB::writeNodeFile(*sphere, tile)) return 1;

    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    std::vector<osg::ref_ptr<osg::PagedLOD>> tiles;
    for (int i = 0, row = 0; i < 9; ++i, row = i / 3)
    {
        tiles.push_back(new osg::PagedLOD);
        tiles.back()->setFileName(0, tile + ".(16,meanwhile=source).legolize");
        tiles.back()->setRange(0, 0.0f, 1e6f);
        tiles.back()->setCenter({0, 0, 0});
        tiles.back()->setRadius(2.0);
        osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform;
        place->setMatrix(osg::Matrix::translate(2.5 * (i % 3 - 1), 2.5 * row, 0.0));
        place->addChild(tiles.back());
        scene->addChild(place);
    }
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.getCamera()->setGraphicsContext(context);
    viewer.getCamera()->setViewport(0, 0, SIZE, SIZE);
    viewer.getCamera()->setProjectionMatrixAsPerspective(40.0, 1.0, 0.1, 100.0);
    viewer.getCamera()->setViewMatrixAsLookAt({0, -12, 6}, {0, 2, 0}, {0, 0, 1});
    viewer.setSceneData(scene);
    const auto isMissing = [](const osg::ref_ptr<osg::PagedLOD>& lod) { return lod->getNumChildren() == 0; };
    std::vector<double> times;
    for (int after = 0; after < 10 && times.size() < 10000; after += std::ranges::none_of(tiles, isMissing) ? 1 : 0)
    {
        const osg::Timer_t begin = osg::Timer::instance()->tick();
        viewer.frame();
        times.push_back(osg::Timer::instance()->delta_m(begin, osg::Timer::instance()->tick()));
    }
    std::ranges::sort(times);
    std::cout << "median " << times[times.size() / 2] << " ms, longest " << times.back() << " ms\n";
    return std::filesystem::remove(tile) && std::ranges::none_of(tiles, isMissing) ? 0 : 1;
}
