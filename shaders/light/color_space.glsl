// Colours are stored as display values; lighting is computed in linear values.

// A screen is usually viewed in a dim room, where a picture looks flatter than the scene. The end-to-end gamma of 1.2 used
// for television (ITU-R BT.709 shown by BT.1886) compensates for this.
const float GAMMA = 2.2 / 1.2;

vec3 toLight(vec3 color)
{
    return pow(color, vec3(GAMMA));
}

// If light of 1 comes from all directions, a surface shows its own colour. The brightest light, mainly highlights,
// approaches white instead of being clipped.
vec3 toColor(vec3 light)
{
    const float SHOULDER = 0.75;
    vec3 above = max(light - SHOULDER, 0.0) / (1.0 - SHOULDER);
    vec3 compressed = min(light, SHOULDER) + (1.0 - SHOULDER) * above / (1.0 + above);
    return pow(max(compressed, 0.0), vec3(1.0 / GAMMA));
}
