#pragma once

#include "AssimpTextures.h"

#include <vector>

#include <assimp/scene.h>
#include <osg/StateSet>
#include <osg/Vec4>
#include <osg/ref_ptr>

/** The materials of a scene as state sets: base colour, base colour texture, alpha mask or blending. Colours are
 * display values, as OpenSceneGraph draws them without conversion; glTF's are linear. One thread. */
class AssimpMaterials
{
public:
    struct Material
    {
        osg::ref_ptr<osg::StateSet> state;
        osg::Vec4 color{1.0f, 1.0f, 1.0f, 1.0f};
        unsigned int textureChannel = 0; //!< the set of texture coordinates
    };

    /** @param isLinear whether the colours of the scene are linear. */
    AssimpMaterials(const aiScene& scene, AssimpTextures& textures, bool isLinear);

    /** @param index of a material of the scene; beyond the last one, a white material. */
    const Material& get(unsigned int index) const;

    /** Convert a colour of the scene to display values, limited to 0 to 1; channels that are not finite become 0. */
    osg::Vec4 toDisplay(const aiColor4D& color) const;

private:
    Material create(const aiMaterial& material, AssimpTextures& textures) const;

    bool _isLinear;
    std::vector<Material> _materials;
    Material _white;
};
