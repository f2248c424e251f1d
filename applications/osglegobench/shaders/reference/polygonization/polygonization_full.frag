// Polygonization, the full look: plastic bricks in the light of the scene and of a light probe. If ambient occlusion
// follows (#define GEOMETRY_BUFFER), it adds the light of the probe.

#include "light/lighting.glsl"
#include "light/fog.glsl"
#include "light/color_space.glsl"
#include "polygonization/brick_surface.glsl"
#if defined(GEOMETRY_BUFFER)
#include "polygonization/geometry_buffer.glsl"
#else
#include "light/ambient_light.glsl"
#endif

uniform bool usesMaterial; // use the specular reflection of osg::Material instead of plastic's

const float PLASTIC_REFLECTANCE = 0.04;
const float LIGHT_SIZE = 0.12; // lights are not points; the slope by which their size widens highlights
// Physically correct highlights would be extremely bright, since lights are small; a headlight would wash out flat faces.
const float HIGHLIGHT = 0.07;

// Direct light from the scene's lights; highlights use Phong's lobe, normalized so that a narrower one is brighter.
vec3 directLight(Surface surface, vec3 albedo)
{
    vec3 toEye = towardsEye(eyePosition);
    vec3 diffuse = vec3(0.0);
    vec3 specular = vec3(0.0);
    float slope = surface.roughness * surface.roughness;
    float shininess = usesMaterial ? gl_FrontMaterial.shininess : 0.5 / (slope * slope + LIGHT_SIZE * LIGHT_SIZE);
    for (int light = 0; light < numLights; ++light)
    {
        int number = lightNumbers[light];
        vec3 toLight = towardsLight(number, eyePosition);
        vec3 direction = normalize(toLight);
        float cosine = max(dot(surface.shading, direction), 0.0) * step(0.0, dot(surface.normal, direction));
        float attenuation = attenuationOf(number, toLight) * cosine;
        float highlight = max(dot(reflect(-direction, surface.shading), toEye), 0.0);
        diffuse += attenuation * gl_LightSource[number].diffuse.rgb;
        specular += attenuation * pow(max(highlight, 1e-4), shininess) * gl_LightSource[number].specular.rgb;
    }
    vec3 reflectance = vec3(HIGHLIGHT * PLASTIC_REFLECTANCE * 0.5 * (shininess + 1.0));
    if (usesMaterial) reflectance = gl_FrontMaterial.specular.rgb;
    return albedo * diffuse + reflectance * specular;
}

#if defined(GEOMETRY_BUFFER)

void main()
{
    Surface surface = surfaceHere();
    vec3 albedo = toLight(surface.color);
    float transmittance = transmittanceAt(eyePosition.z);
    if (numLights < 0)
    {
        vec3 shown = mix(gl_Fog.color.rgb, unpackUnorm4x8(color).rgb, transmittance);
        gl_FragData[0] = vec4(shown, 1.0);
        gl_FragData[1] = vec4(0.0);
        gl_FragData[2] = vec4(toOctahedron(surface.normal), 0.0, UNLIT);
        return;
    }
    vec3 light = directLight(surface, albedo) * surface.openness;
    gl_FragData[0] = vec4(light, surface.roughness);
    gl_FragData[1] = vec4(surface.color * pow(surface.openness, 1.0 / 2.2), transmittance);
    gl_FragData[2] = packNormals(surface.normal, surface.shading);
}

#else

void main()
{
    Surface surface = surfaceHere();
    float transmittance = transmittanceAt(eyePosition.z);
    vec3 shown = unpackUnorm4x8(color).rgb;
    if (numLights >= 0)
    {
        vec3 albedo = toLight(surface.color);
        vec3 ambient = albedo * irradianceAt(surface.shading) +
                       reflectionAt(surface.shading, towardsEye(eyePosition), surface.roughness);
        shown = toColor((directLight(surface, albedo) + ambient) * surface.openness);
    }
    gl_FragColor = vec4(mix(gl_Fog.color.rgb, shown, transmittance), 1.0);
}

#endif
