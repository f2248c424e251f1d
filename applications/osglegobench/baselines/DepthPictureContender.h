#pragma once

#include "DepthPicture.h"
#include "ReadBackContender.h"

#include <array>

#include <osg/Program>

namespace osgLego
{

/** Two methods that find the cells, with their colours, from depth pictures along x, y and z. Both miss cells whose
 * surface is between the centres of pixels along all axes.
 *
 * Six depth buffers: Karabassi, Papaioannou, Theoharis, "A Fast Depth-Buffer-Based Voxelization Algorithm", 1999: the
 * nearest surface and the farthest. The published method creates a solid: it fills all cells between both depths along
 * all three axes. Here only the surface is needed, as for all contenders. Surfaces not visible from outside along any
 * axis (cavities, folds) are not found.
 *
 * Layers of depth: Passalis, Toderici, Theoharis, Kakadiaris, "General Voxelization Algorithm with Scalable GPU
 * Implementation", 2007: every layer is the nearest surface behind the last one, until an occlusion query finds
 * nothing more to draw. Cavities are found.
 */
class DepthPictureContender : public ReadBackContender
{
public:
    enum class Method
    {
        KARABASSI,
        PASSALIS
    };

    explicit DepthPictureContender(Method method) : _method(method) {}

    std::string getName() const override { return _method == Method::KARABASSI ? "karabassi" : "passalis"; }
    bool hasColors() const override { return true; }

protected:
    std::string createObjects(osg::State& state) override;
    void gatherCells(osg::State& state, GatheredCells& cells) override;
    void releaseObjects() override;

private:
    void drawBothEnds(osg::State& state, DepthPicture& picture, GatheredCells& cells) const;
    void peel(osg::State& state, DepthPicture& picture, GatheredCells& cells) const;
    bool drawLayer(osg::State& state, const DepthPicture& picture, std::size_t layer) const;

    Method _method;
    std::array<DepthPicture, 3> _pictures; // along x, y and z
    osg::ref_ptr<osg::Program> _program;
    GlQuery _query;
};

} // namespace osgLego
