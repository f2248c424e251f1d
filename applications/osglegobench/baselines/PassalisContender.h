#pragma once

#include "DepthPicture.h"
#include "ReadBackContender.h"

#include <osg/Program>

namespace osgLego
{

/** Layers of depth: Passalis, Toderici, Theoharis, Kakadiaris, "General Voxelization Algorithm with Scalable GPU
 * Implementation", 2007.
 *
 * Along each of x, y and z the mesh is peeled: every layer is the nearest surface behind the last one, until an
 * occlusion query says that nothing was left to draw. The cells of all layers are taken, with the colours drawn with
 * the depths. Cavities are found; what falls between the centres of pixels on all three axes is not.
 */
class PassalisContender : public ReadBackContender
{
public:
    std::string getName() const override { return "passalis"; }
    bool hasColors() const override { return true; }

protected:
    std::string createObjects(osg::State& state) override;
    void gatherCells(osg::State& state, GatheredCells& cells) override;
    void releaseObjects() override;

private:
    void peel(osg::State& state, DepthPicture& picture, GatheredCells& cells) const;
    bool drawLayer(osg::State& state, const DepthPicture& picture, std::size_t layer) const;

    DepthPictures _pictures;
    osg::ref_ptr<osg::Program> _program;
    GlQuery _query;
};

} // namespace osgLego
