// Colours are kept as they are shown; light is reckoned in proportion to its power.

vec3 toLight(vec3 color)
{
    return pow(color, vec3(2.2));
}

// Where a light of 0.8, as OSG's are, and one from all around add up, a surface shows its own colour; the brightest light,
// highlights above all, comes near white instead of being cut off.
vec3 toColor(vec3 light)
{
    const float EXPOSURE = 0.78;
    const float SHOULDER = 0.75;
    light *= EXPOSURE;
    vec3 above = max(light - SHOULDER, 0.0) / (1.0 - SHOULDER);
    vec3 compressed = min(light, SHOULDER) + (1.0 - SHOULDER) * above / (1.0 + above);
    return pow(max(compressed, 0.0), vec3(1.0 / 2.2));
}
