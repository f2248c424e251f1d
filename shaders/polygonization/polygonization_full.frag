// Polygonization, the full look: plastic bricks in the light of the scene and of a light probe. If ambient occlusion
// follows (#define GEOMETRY_BUFFER), it adds the light of the probe.

#if defined(GEOMETRY_BUFFER)
#define NUM_OUTPUTS 4 // light and roughness, albedo and transmittance, and those of geometry_buffer.glsl
#endif
#include "gl/fragment_outputs.glsl"
#include "polygonization/brick_surface.glsl"
#include "light/lighting.glsl"
#include "light/fog.glsl"
#include "polygonization/shadows.glsl"
#include "light/color_space.glsl"
#if defined(GEOMETRY_BUFFER)
#include "polygonization/geometry_buffer.glsl"
#else
#include "light/ambient_light.glsl"
#endif
#if defined(DISTANT_OCCLUSION)
#include "polygonization/distant_occlusion.glsl"
#endif
#if defined(GRID_OCCLUSION)
#include "polygonization/near_occlusion.glsl"
#endif
#include "light/distant_light.glsl"

uniform bool usesMaterial; // use the specular reflection of osg::Material instead of plastic's

const float PLASTIC_REFLECTANCE = 0.04;
const float LIGHT_SIZE = 0.12; // lights are not points; the slope by which their size widens highlights
// The scene's lights are added to the environment light, which alone shows the shape of an object lit by a headlight. They
// are usually set up for scenes without environment light; at full brightness they would drown it.
const float DIRECT_SHARE = 1.0 / 6.0;
// Physically correct highlights would be extremely bright, since lights are small; a headlight would wash out flat faces.
const float HIGHLIGHT = 0.02;

// In the shadow of all lights, surfaces that face them lose this fraction of the environment light, too: without the lights
// alone, bricks would be hardly darker.
const float SHADOW_DARKNESS = 0.6;

// The cosine of the angle between a surface and a light; the mean of the cosines of faces that are shaded as one.
float cosineTo(Surface surface, vec3 direction)
{
    float cosine = max(dot(surface.shading, direction), 0.0) * step(0.0, dot(surface.normal, direction));
    if (surface.merged == 0.0) return cosine;
    float sum = ROUND_WALL * surface.wall * max(dot(surface.wallNormal, direction), 0.0);
    for (int axis = 0; axis < 3; ++axis)
        sum += max(surface.faces[axis] * dot(axisOf(axis), direction), 0.0);
    return mix(cosine, sum, surface.merged);
}

// Direct light from the scene's lights; highlights use Phong's lobe, normalized so that a narrower one is brighter.
// `environment` is the fraction of the environment light that shadows leave.
vec3 directLight(Surface surface, vec3 albedo, out float environment)
{
    float hidden = 0.0;
    float all = 1e-5;
    vec3 toEye = towardsEye(eyePosition);
    vec3 diffuse = vec3(0.0);
    vec3 specular = vec3(0.0);
    float slope = surface.roughness * surface.roughness;
    float shininess = usesMaterial ? frontMaterial.shininess : 0.5 / (slope * slope + LIGHT_SIZE * LIGHT_SIZE);
    for (int place = 0; place < numLights; ++place)
    {
        Light light = lightAt(place);
        vec3 toLight = towardsLight(light, eyePosition);
        vec3 direction = normalize(toLight);
        float cosine = cosineTo(surface, direction);
        float share = litShare(place, eyePosition, surface.normal, surface.lift);
        float brightness = dot(light.diffuse, vec3(1.0));
        hidden += brightness * cosine * (1.0 - share);
        all += brightness;
        float attenuation = attenuationOf(light, toLight) * cosine * share;
        float highlight = max(dot(reflect(-direction, surface.shading), toEye), 0.0);
        diffuse += attenuation * DIRECT_SHARE * light.diffuse;
        specular += attenuation * pow(max(highlight, 1e-4), shininess) * light.specular;
    }
    environment = 1.0 - SHADOW_DARKNESS * hidden / all;
    vec3 reflectance = vec3(HIGHLIGHT * PLASTIC_REFLECTANCE * 0.5 * (shininess + 1.0));
    if (usesMaterial) reflectance = frontMaterial.specular.rgb;
    return albedo * diffuse + reflectance * specular;
}

// The colour without lighting.
vec3 unlitColor(Surface surface)
{
    vec3 own = unpackUnorm4x8(color).rgb;
#if defined(LINES)
    own = drawnColor(own, surface.drawing);
#endif
    return own;
}

#if defined(DISTANT_OCCLUSION)

// `shift` is a step from the surface to the place of the occlusion, in cells. The wall of a stud sees the
// upper half of its sky. Both cases share the look-ups: software renderers run both branches for every pixel.
vec4 distantOcclusionOf(Surface surface, vec3 shift)
{
    bool isWall = (detail & 3u) == STUD_WALL;
    vec3 lift = isWall ? surface.outward : surface.normal;
    vec3 middle = isWall ? normalize(surface.normal + lift) : surface.normal;
    vec4 hidden = distantOcclusionAt(eyePosition, middle, shift, lift, towardsEye(eyePosition), includesNear && !isWall);
    return (isWall ? 0.5 : 1.0) * vec4(hidden.xyz, hidden.w + dot(hidden.xyz, middle - surface.normal));
}

#endif

#if defined(GRID_OCCLUSION) || defined(OWN_OCCLUSION)

// The share of the light hidden by distant bricks that near bricks hide, too; and of that hidden by bricks that studs hide, too. With
// these, errors against rays are smallest.
const float NEAR_OVERLAP = 0.5;
const float STUD_OVERLAP = 0.3;

// The mean open direction, and the visible fraction of the sky.
vec4 openSky(Surface surface)
{
#if defined(GRID_OCCLUSION)
    vec3 shift;
    vec4 open = nearOcclusion(surface, shift);
#if defined(DISTANT_OCCLUSION)
    float overlap = !hasFaceOcclusion ? 1.0 : includesNear && (detail & 3u) != STUD_WALL ? STUD_OVERLAP : NEAR_OVERLAP;
    occludeFromAfar(distantOcclusionOf(surface, shift), surface.normal, overlap, open.xyz, open.w);
#endif
    return open;
#else
    return vec4(surface.normal, 1.0);
#endif
}

#endif

// The light that edges, studs and near faces leave to faces smaller than a pixel: to those beside studs, and to others. Occlusion
// accounts for some of it. With these, the mean brightness of models is about that of pictures that show each brick.
const vec2 MERGED = vec2(0.94, 0.94); // without occlusion
const vec2 MERGED_OCCLUDED = vec2(0.98, 0.98);
const vec2 MERGED_FACES = vec2(0.77, 0.98); // occlusion of the middles of faces leaves out that by their own studs
const vec2 MERGED_LATER = vec2(0.8, 0.8);   // passes that follow see the faces from the side of the eye

float mergedOpenness(Surface surface)
{
#if defined(GEOMETRY_BUFFER)
    vec2 merged = MERGED_LATER;
#elif defined(GRID_OCCLUSION) && defined(DISTANT_OCCLUSION)
    vec2 merged = hasFaceOcclusion ? MERGED_FACES : MERGED_OCCLUDED;
#elif defined(GRID_OCCLUSION)
    vec2 merged = MERGED_OCCLUDED;
#else
    vec2 merged = MERGED;
#endif
    float besideStuds = surface.wall + max(surface.faces[upAxis], 0.0);
    return mix(1.0, mix(merged.y, merged.x, besideStuds), surface.merged);
}

#if defined(GEOMETRY_BUFFER)

#if defined(OWN_OCCLUSION)
uniform int occluder; // the number of the node
#endif

void main()
{
    if (!findFragment()) discard;
    Surface surface = surfaceHere(towardsEye(eyePosition));
    surface.openness *= mergedOpenness(surface);
    vec3 albedo = toLight(surface.color);
    float transmittance = transmittanceAt(eyePosition.z);
    if (numLights < 0)
    {
        vec3 shown = mix(fogColor, unlitColor(surface), transmittance);
        fragmentData[0] = vec4(shown, 1.0);
        fragmentData[1] = vec4(0.0);
        fragmentData[2] = vec4(toOctahedron(surface.normal), 0.0, UNLIT);
        fragmentData[3] = packDistant(vec4(0.0));
        return;
    }
    float environment;
    vec3 light = directLight(surface, albedo, environment) * surface.openness;
    fragmentData[1] = vec4(surface.color * pow(environment * surface.openness, 1.0 / GAMMA), transmittance);
    fragmentData[2] = packNormals(surface.normal, surface.shading);
#if defined(OWN_OCCLUSION)
    vec4 open = openSky(surface);
    fragmentData[0] = vec4(light, -surface.roughness);
    fragmentData[3] = packOcclusion(OwnOcclusion(open.xyz, open.w, occluder));
#else
    fragmentData[0] = vec4(light, surface.roughness);
#if defined(DISTANT_OCCLUSION)
    fragmentData[3] = packDistant(distantOcclusionOf(surface, vec3(0.0)));
#else
    fragmentData[3] = packDistant(vec4(0.0));
#endif
#endif
}

#else

// The irradiance of a surface with a normal; the mean of those of faces that are shaded as one.
vec3 irradianceOf(Surface surface, vec3 normal)
{
    vec3 irradiance = irradianceAt(normal);
    if (surface.merged == 0.0) return irradiance;
    vec3 sum = surface.wall * irradianceAt(surface.wallNormal);
    for (int axis = 0; axis < 3; ++axis)
        if (surface.faces[axis] != 0.0)
            sum += abs(surface.faces[axis]) * irradianceAt(sign(surface.faces[axis]) * axisOf(axis));
    return mix(irradiance, sum, surface.merged);
}

void main()
{
    if (!findFragment()) discard;
    Surface surface = surfaceHere(towardsEye(eyePosition));
    surface.openness *= mergedOpenness(surface);
    float transmittance = transmittanceAt(eyePosition.z);
    vec3 shown = unlitColor(surface);
    if (numLights >= 0)
    {
        vec3 albedo = toLight(surface.color);
        float environment;
        vec3 direct = directLight(surface, albedo, environment);
        vec3 toEye = towardsEye(eyePosition);
#if defined(GRID_OCCLUSION)
        vec4 open = openSky(surface);
        vec3 bent = normalize(open.xyz + surface.shading - surface.normal);
        float mirrored = reflectionVisibility(max(dot(surface.shading, toEye), 0.0), open.w, surface.roughness);
        vec3 ambient = environment * albedo * open.w * irradianceOf(surface, bent) +
                       mirrored * reflectionAt(surface.shading, toEye, surface.roughness);
#else
        vec3 ambient = environment * albedo * irradianceOf(surface, surface.shading) +
                       reflectionAt(surface.shading, toEye, surface.roughness);
#endif
        shown = toColor((direct + ambient) * surface.openness);
    }
    fragmentColor = vec4(mix(fogColor, shown, transmittance), 1.0);
}

#endif
