// A skinned osgAnimation figure that bends and walks through a lattice of the world, which stays.

#include <osgLego/LegoNode.h>

#include <iostream>

#include <osg/MatrixTransform>
#include <osgAnimation/Bone>
#include <osgAnimation/RigGeometry>
#include <osgAnimation/Skeleton>
#include <osgUtil/UpdateVisitor>

int main()
{
    // A ribbon of 1 x 4 units, whose upper half moves with the bone "top".
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const osg::ref_ptr<osgAnimation::VertexInfluenceMap> influences = new osgAnimation::VertexInfluenceMap;
    for (unsigned int i = 0; i < 18; ++i)
    {
        const unsigned int row = i / 2;
        vertices->push_back({i % 2 == 0 ? -0.5f : 0.5f, 0.1f, 0.5f * static_cast<float>(row)});
        (*influences)[i < 10 ? "foot" : "top"].push_back({i, 1.0f});
    }
    const osg::ref_ptr<osgAnimation::RigGeometry> skin = new osgAnimation::RigGeometry;
    skin->setVertexArray(vertices);
    skin->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 18));
    skin->setSourceGeometry(new osg::Geometry(*skin, osg::CopyOp::DEEP_COPY_ALL));
    skin->setInfluenceMap(influences);
    skin->setDataVariance(osg::Object::DYNAMIC); // its vertices change in every frame
    const osg::ref_ptr<osgAnimation::Bone> foot = new osgAnimation::Bone("foot");
    const osg::ref_ptr<osgAnimation::Bone> top = new osgAnimation::Bone("top");
    const osg::ref_ptr<osgAnimation::Skeleton> skeleton = new osgAnimation::Skeleton;
    skeleton->setDefaultUpdateCallback();
    foot->addChild(top);
    skeleton->addChild(foot);
    skeleton->addChild(skin);

    osgLego::LegoSettings settings;
    std::string error;
    if (!osgLego::LegoSettings::parse("cell=0.25,anchor=world,parts=bricks,effort=instant", settings, error)) return 1;
    const osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode(settings);
    lego->addChild(skeleton);
    const osg::ref_ptr<osg::MatrixTransform> walk = new osg::MatrixTransform;
    walk->addChild(lego);
    osgUtil::UpdateVisitor update; // instead of a viewer's
    osg::BoundingBoxd bounds;
    for (unsigned int frame = 0; frame < 10; ++frame)
    {
        top->setMatrixInSkeletonSpace(osg::Matrix::translate(0.1 * frame, 0.0, 0.0));
        walk->setMatrix(osg::Matrix::translate(0.0, 0.3 * frame, 0.0));
        update.setTraversalNumber(frame);
        walk->accept(update);
        bounds = lego->getBricks()->getGrid().getBrickBounds();
        std::cout << lego->getBricks()->getParts().size() << " parts from y = " << bounds.yMin() << '\n';
    }
    // From -0.5 at the foot to 0.5 + 0.9 at the top; the ribbon has walked from 0.1 by 2.7.
    return bounds.xMin() == -0.5 && bounds.xMax() == 1.5 && bounds.yMin() == 2.75 ? 0 : 1;
}
