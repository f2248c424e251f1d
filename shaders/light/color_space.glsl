// Colours are kept as they are shown; light is computed in proportion to its power.

// A picture on a screen is seen in a dim room, where it looks flatter than the scene did. The 1.2 that television has from end
// to end (ITU-R BT.709 shown by BT.1886) makes up for that.
const float GAMMA = 2.2 / 1.2;

vec3 toLight(vec3 color)
{
    return pow(color, vec3(GAMMA));
}

// In light of 1 from all around a surface shows its own colour; the brightest light, highlights above all, comes near white
// instead of being cut off.
vec3 toColor(vec3 light)
{
    const float SHOULDER = 0.75;
    vec3 above = max(light - SHOULDER, 0.0) / (1.0 - SHOULDER);
    vec3 compressed = min(light, SHOULDER) + (1.0 - SHOULDER) * above / (1.0 + above);
    return pow(max(compressed, 0.0), vec3(1.0 / GAMMA));
}
