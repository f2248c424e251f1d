#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/polygonization/Faces.h>

#include <array>
#include <mutex>
#include <string>

#include <osg/Image>
#include <osg/Quat>
#include <osg/Referenced>
#include <osg/State>
#include <osg/StateSet>
#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** The state sets that draw bricks in one look: programs, uniforms and textures, none of which depends on the bricks.
 * All nodes with the same look share them, so that many nodes compile their programs once.
 *
 * Immutable except for GL objects, which SharedGlObjects releases. Functions may be called from any thread.
 */
class BrickStates : public osg::Referenced
{
public:
    // The texture units of splats; different from the units of the relief, of distant occlusion and of the light probe.
    static constexpr unsigned int BRICKS_UNIT = 1;
    static constexpr unsigned int SPLATS_UNIT = 4;
    static constexpr unsigned int DEPTHS_UNIT = 5;

    /** The targets that bricks are drawn into. */
    enum class Target
    {
        FRAME, //!< a frame without AmbientOcclusionScene
        BUFFER //!< the geometry buffer of an AmbientOcclusionScene
    };

    /** What programs are for; they differ in these properties. */
    struct Kind
    {
        Target target = Target::FRAME;
        bool isPartial = false; //!< whether the model is drawn partly built (BrickStore::getBuilding())
        bool hasLines = false;  //!< whether lines are drawn at the edges of parts, or parts are faded

        // In the full look:
        bool hasGridOcclusion = false;    //!< whether the cells around bricks occlude them
        bool hasDistantOcclusion = false; //!< whether distant bricks occlude them
        bool hasOwnOcclusion = false;     //!< whether no brick of the node occludes them in the picture of the buffer

        bool operator==(const Kind&) const = default;
    };

    /** Find the states of a look, or create them if no node has them. In the plain look, the target, the appearance and
     * the probe make no difference. */
    static osg::ref_ptr<const BrickStates> get(Look look, const Kind& kind, const BrickAppearance& appearance,
                                               const LightProbe& probe);

    /** The states of the programs that shade bricks. */
    struct Shading
    {
        osg::ref_ptr<osg::StateSet> triangles;        //!< for drawing with the geometry shader
        osg::ref_ptr<osg::StateSet> splats;           //!< in scenes with any number of lights
        osg::ref_ptr<osg::StateSet> splatsByOneLight; //!< in scenes with one light
    };

    /** For drawing with the geometry shader, without shadows of the scene. */
    osg::StateSet& getTriangles() const { return *_shading.triangles; }
    /** The states for bricks with or without shadows of the scene (ShadowMaps). Those with shadows are created at the
     * first call. */
    Shading getShading(bool hasShadows) const;
    /** Likewise, for triangles with the clip planes of a core context (CoreClipPlanes). */
    const osg::StateSet& getClippedTriangles(bool hasShadows) const;
    /** For finding the splats of bricks with or without visible studs. */
    const osg::StateSet& getPoints(bool hasStuds) const { return hasStuds ? *_studded : *_boxes; }

    /** For drawing with the geometry shader into a depth buffer without colours. */
    const osg::StateSet& getDepths(bool hasClipPlanes) const { return hasClipPlanes ? *_clippedDepths : *_depths; }
    /** For drawing bricks with or without visible studs right into such a buffer, as points.
     * @param faces not all. */
    const osg::StateSet& getDepthPoints(Faces faces, bool hasStuds) const
    {
        return *_depthPoints[faces == Faces::BACK ? 1 : 0][hasStuds ? 1 : 0];
    }

    /** For finding the neighbours in place (shaders/polygonization/partial_neighbors.vert). For models drawn partly
     * built with grid occlusion. */
    const osg::StateSet& getPartialNeighbors() const { return *_partialNeighbors; }

    void resizeGLObjectBuffers(unsigned int maxSize) const;

private:
    /** The values that determine the states. */
    struct Key
    {
        Key(Look look, const Kind& kind, const BrickAppearance& appearance, const LightProbe& probe);
        bool operator==(const Key&) const = default;

        Look look;
        Kind kind;
        BrickAppearance appearance; // without the image
        osg::observer_ptr<const osg::Image> relief;
        unsigned int reliefCount = 0;              // Image::getModifiedCount()
        osg::observer_ptr<const osg::Image> light; // the convolved map, which each light has
        osg::Quat rotation;
        double intensity = 0.0;
    };

    BrickStates(Look look, const Kind& kind, const BrickAppearance& appearance, const LightProbe& probe);
    ~BrickStates() override = default;

    Look _look;
    std::string _definitions;
    osg::ref_ptr<osg::StateSet> _common; // of all programs for shading
    Shading _shading;
    osg::ref_ptr<osg::StateSet> _boxes;
    osg::ref_ptr<osg::StateSet> _studded;
    osg::ref_ptr<osg::StateSet> _partialNeighbors;
    osg::ref_ptr<osg::StateSet> _depths;
    osg::ref_ptr<osg::StateSet> _clippedDepths;
    std::array<std::array<osg::ref_ptr<osg::StateSet>, 2>, 2> _depthPoints; // by getDepthPoints()
    mutable std::mutex _mutex;
    mutable Shading _shadowed;
    mutable std::array<osg::ref_ptr<osg::StateSet>, 2> _clipped; // triangles, without and with shadows
};

} // namespace osgLego
