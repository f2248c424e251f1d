// The packed colour of a vertex and the mipmap level of its texture.

#include "osgLego/data/PassConstants.h"

// Two words: red, green | blue, level.
vec4 unpackColorAndLevel(uvec2 words)
{
    vec4 fractions = vec4(unpackUnorm2x16(words.x), unpackUnorm2x16(words.y));
    return vec4(fractions.rgb, fractions.a * MAXIMUM_LEVEL);
}

uvec2 packColorAndLevel(vec4 colorAndLevel)
{
    vec4 fractions = vec4(colorAndLevel.rgb, colorAndLevel.a / MAXIMUM_LEVEL);
    return uvec2(packUnorm2x16(fractions.rg), packUnorm2x16(fractions.ba));
}
