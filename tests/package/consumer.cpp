#include <iostream>
#include <osg/Geometry>
#include <osgLego/LegoNode.h>
#include <osgLegoBooklet/Booklet.h>

int main()
{
    osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode;
    lego->addChild(osg::createTexturedQuadGeometry(osg::Vec3(), osg::Vec3(1, 0, 0), osg::Vec3(0, 0, 1)));
    if (osgLego::nameBooklet("quad.osgt") != "quad") return 1;
    std::cout << lego->getBricks()->getBricks().size() << " bricks\n";
}
