// Colours are kept as they are shown; light is reckoned in proportion to its power.

vec3 toLight(vec3 color)
{
    return pow(color, vec3(2.2));
}

// The brightest light, highlights above all, comes near white instead of being cut off.
vec3 toColor(vec3 light)
{
    const float SHOULDER = 0.8;
    vec3 above = max(light - SHOULDER, 0.0) / (1.0 - SHOULDER);
    vec3 compressed = min(light, SHOULDER) + (1.0 - SHOULDER) * above / (1.0 + above);
    return pow(max(compressed, 0.0), vec3(1.0 / 2.2));
}
