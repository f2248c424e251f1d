#include <osgLego/GeometryBufferStage.h>

#include <algorithm>

#include <osg/ref_ptr>
#include <osgUtil/PositionalStateContainer>

namespace osgLego
{

namespace
{

/** What a stage inherits, which it tells nobody but its own kind. */
class Inheritance : public osgUtil::RenderStage
{
public:
    static osgUtil::PositionalStateContainer* getState(const osgUtil::RenderStage& stage)
    {
        return (stage.*(&Inheritance::_inheritedPositionalStateContainer)).get();
    }
    static const osg::Matrix& getMatrix(const osgUtil::RenderStage& stage)
    {
        return stage.*(&Inheritance::_inheritedPositionalStateContainerMatrix);
    }
};

/** The positional state of a stage, behind what it inherits. */
class StateOfStage : public osgUtil::PositionalStateContainer
{
public:
    explicit StateOfStage(osgUtil::RenderStage& stage) :
        _inherited(Inheritance::getState(stage)), _matrix(Inheritance::getMatrix(stage)),
        _own(stage.getPositionalStateContainer())
    {
    }

    void draw(osg::State& state, osgUtil::RenderLeaf*& previous, const osg::Matrix*) override
    {
        if (_inherited) _inherited->draw(state, previous, &_matrix);
        _own->draw(state, previous, nullptr);
    }

private:
    osg::ref_ptr<osgUtil::PositionalStateContainer> _inherited;
    osg::Matrix _matrix;
    osg::ref_ptr<osgUtil::PositionalStateContainer> _own;
};

} // namespace

void GeometryBufferStage::reset()
{
    osgUtil::RenderStage::reset();
    _pitch = 0.0;
}

void GeometryBufferStage::inheritPositionalState(osgUtil::RenderStage& outer)
{
    setInheritedPositionalStateContainer(new StateOfStage(outer));
    setInheritedPositionalStateContainerMatrix(osg::Matrix());
}

void GeometryBufferStage::noteBricks(double pitch, const osg::Matrixd& modelView)
{
    const double scale = osg::Matrixd::transform3x3(osg::Vec3d(1.0, 0.0, 0.0), modelView).length();
    _pitch = std::max(_pitch, scale * pitch);
}

} // namespace osgLego
