// A texel of the voxel image. With WEIGHTED_COLORS it is the sum of weighted colours, and the sum of weights in alpha,
// usually as half floats: colours are centred around 0, where these are most precise. Otherwise it is the colour.

#include "osgLego/data/PassConstants.h"

vec4 weightedColor(vec3 color, float weight)
{
    return WEIGHT_SCALE * weight * vec4(color - COLOR_CENTER, 1.0);
}

vec3 colorOfVoxel(vec4 voxel)
{
#ifdef WEIGHTED_COLORS
    return COLOR_CENTER + voxel.rgb / (isinf(voxel.a) ? LARGEST_SUM : voxel.a);
#else
    return voxel.rgb;
#endif
}
