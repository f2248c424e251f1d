#include <common/UprightTurn.h>

namespace osgLego
{

namespace
{

// Exact, without the rounding errors of osg::Matrixd::rotate().
const osg::Matrixd TURN(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);

} // namespace

const osg::Matrixd& getUprightTurn()
{
    return TURN;
}

osg::ref_ptr<osg::MatrixTransform> turnUpright(osg::Node& node)
{
    osg::ref_ptr<osg::MatrixTransform> turn = new osg::MatrixTransform(TURN);
    // The optimizer, which every osgviewer runs, would otherwise turn the geometry instead of the bricks made from it.
    turn->setDataVariance(osg::Object::DYNAMIC);
    turn->setName(node.getName());
    turn->addChild(&node);
    return turn;
}

bool isUprightTurn(const osg::Node& node)
{
    const auto* transform = dynamic_cast<const osg::MatrixTransform*>(&node);
    return transform && transform->getNumChildren() == 1 && transform->getMatrix() == TURN;
}

} // namespace osgLego
