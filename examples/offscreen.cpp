// Draws bricks without a display, and writes the picture to a file if the first argument names one.

#include <osgLego/LegoNode.h>

#include <offscreen/OffscreenContext.h>

#include <iostream>

#include <osg/ShapeDrawable>
#include <osgDB/WriteFile>
#include <osgViewer/Viewer>

int main(int argc, char** argv)
{
    constexpr int SIZE = 256; // pixels
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = osgLego::createOffscreenContext(SIZE, SIZE, error);
    if (!context)
    {
        std::cerr << error << '\n';
        return 1;
    }
    osgLego::LegoSettings settings;
    settings.grid.resolution = 24;
    const osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode(settings);
    lego->addChild(new osg::ShapeDrawable(new osg::Cone({0, 0, 0}, 1.0f, 2.0f)));
    lego->setWaiting(true); // the only frame must show the bricks

    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.getCamera()->setGraphicsContext(context);
    viewer.getCamera()->setViewport(0, 0, SIZE, SIZE);
    viewer.getCamera()->setClearColor({0, 0, 0, 1});
    viewer.getCamera()->setProjectionMatrixAsPerspective(30.0, 1.0, 0.1, 100.0);
    viewer.getCamera()->setViewMatrixAsLookAt({0, -7, 2}, {0, 0, 0}, {0, 0, 1});
    const osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(SIZE, SIZE, 1, GL_RGB, GL_UNSIGNED_BYTE);
    viewer.getCamera()->attach(osg::Camera::COLOR_BUFFER, picture);
    viewer.setSceneData(lego);
    viewer.frame();

    if (argc > 1 && !osgDB::writeImageFile(*picture, argv[1])) return 1;
    const unsigned char* middle = picture->data(SIZE / 2, SIZE / 2);
    std::cout << lego->getBricks()->getBricks().size() << " bricks\n";
    return lego->isLegolized(context->getState()->getContextID()) && middle[0] > 20 ? 0 : 1;
}
