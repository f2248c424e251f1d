// The packed colour of a vertex and the mipmap level of its texture.

#include "osgLego/data/PassConstants.h"

// Two words: red, green | blue, level.
vec4 unpackColorAndLevel(uvec2 words)
{
    vec4 fractions = vec4(unpackUnorm2x16(words.x), unpackUnorm2x16(words.y));
    return vec4(fractions.rgb, mix(MINIMUM_LEVEL, MAXIMUM_LEVEL, fractions.a));
}

uvec2 packColorAndLevel(vec4 colorAndLevel)
{
    float level = (colorAndLevel.a - MINIMUM_LEVEL) / (MAXIMUM_LEVEL - MINIMUM_LEVEL);
    vec4 fractions = vec4(colorAndLevel.rgb, level);
    return uvec2(packUnorm2x16(fractions.rg), packUnorm2x16(fractions.ba));
}
