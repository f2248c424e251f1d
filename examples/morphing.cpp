// A morphing model in the lattice of its first state: parts far from the change stay as they are.

#include <osgLego/LegoNode.h>

#include <array>
#include <iostream>
#include <set>

#include <osg/ShapeDrawable>
#include <osgAnimation/MorphGeometry>
#include <osgUtil/UpdateVisitor>

int main()
{
    // A box that grows at one end, from 4 units along x to 8.
    const auto createBox = [](float length)
    {
        const osg::ref_ptr<osg::ShapeDrawable> box =
            new osg::ShapeDrawable(new osg::Box({0.5f * length + 0.01f, 0.0f, 0.0f}, length, 1.5f, 1.5f));
        return osg::ref_ptr(new osg::Geometry(*box, osg::CopyOp::DEEP_COPY_ALL));
    };
    const osg::ref_ptr<osgAnimation::MorphGeometry> morph = new osgAnimation::MorphGeometry(*createBox(4.0f));
    morph->setMethod(osgAnimation::MorphGeometry::NORMALIZED);
    morph->addMorphTarget(createBox(8.0f), 0.0f);
    morph->setDataVariance(osg::Object::DYNAMIC); // its vertices change in every frame

    osgLego::LegoSettings settings;
    std::string error;
    if (!osgLego::LegoSettings::parse("60,anchor=first,parts=bricks", settings, error)) return 1;
    const osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode(settings);
    lego->addChild(morph);
    osgUtil::UpdateVisitor update;      // instead of a viewer's
    std::set<std::array<int, 4>> first; // the places and lengths of parts far from the end that moves
    for (unsigned int frame = 0; frame <= 10; ++frame)
    {
        morph->setWeight(0, 0.1f * static_cast<float>(frame));
        update.setTraversalNumber(frame);
        lego->accept(update);
        std::set<std::array<int, 4>> far;
        for (const osgLego::Part& part : lego->getBricks()->getParts())
            if (part.cell[0] + part.size[0] <= 20) far.insert({part.cell[0], part.cell[1], part.cell[2], part.size[0]});
        std::cout << lego->getBricks()->getParts().size() << " parts, " << far.size() << " of them far\n";
        if (frame == 0) first = far;
        if (first.empty() || far != first) return 1;
    }
    return lego->getBricks()->getGrid().dimensions.x > 100 ? 0 : 1;
}
