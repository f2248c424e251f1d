// Polygonization, the plain look: Phong's lighting model per pixel, with the scene's lights.

#include "gl/fragment_outputs.glsl"
#include "polygonization/brick_fragment.glsl"
#include "light/lighting.glsl"
#include "light/fog.glsl"
#include "polygonization/shadows.glsl"
#if defined(LINES)
#include "polygonization/part_lines.glsl"
#endif

const float SPECULAR = 0.1; // fraction of the light; the rest is diffuse
const float SHININESS = 48.0;

vec3 shade(vec3 albedo)
{
    if (numLights < 0) return albedo;
    vec3 normal = normalize(isOutside ? eyeNormal : -eyeNormal);
    vec3 toEye = towardsEye(eyePosition);
    vec3 diffuse = ambientOfAll;
    vec3 specular = vec3(0.0);
    for (int place = 0; place < numLights; ++place)
    {
        Light light = lightAt(place);
        vec3 toLight = towardsLight(light, eyePosition);
        float attenuation = attenuationOf(light, toLight);
        vec3 direction = normalize(toLight);
        float cosine = max(dot(normal, direction), 0.0);
        float highlight = cosine > 0.0 ? max(dot(reflect(-direction, normal), toEye), 0.0) : 0.0;
        float share = litShare(place, eyePosition, normal, 0.0);
        diffuse += attenuation * (light.ambient + share * cosine * light.diffuse);
        specular += share * attenuation * pow(highlight, SHININESS) * light.specular;
    }
    return mix(albedo * diffuse, specular, SPECULAR);
}

void main()
{
    if (!findFragment()) discard;
    vec3 albedo = unpackUnorm4x8(color).rgb;
#if defined(LINES)
    albedo = drawnColor(albedo, drawingHere(towardsEye(eyePosition)));
#endif
    vec3 shaded = shade(albedo);
    fragmentColor = vec4(mix(fogColor, shaded, transmittanceAt(eyePosition.z)), 1.0);
}
