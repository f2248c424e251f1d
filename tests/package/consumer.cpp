#include <iostream>
#include <osgLego/LegoNode.h>
#include <osgLego/RacingCar.h>

int main()
{
    osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode;
    lego->addChild(osgLego::createRacingCar());
    std::cout << lego->getBricks()->getBricks().size() << " bricks\n";
}
