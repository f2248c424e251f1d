// The scene's lights, as osg::Light describes them.

#include "gl/fixed_state.glsl"

struct Light
{
    vec4 position;
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    vec3 attenuation; // constant, linear, quadratic
    vec3 spotDirection;
    float spotCutoff;
    float spotCosCutoff;
    float spotExponent;
};

#if defined(SPLATS)
#define ambientOfAll sceneAmbient.rgb
#define eyeIsPlace (sceneNormals[2].w == 0.0)
#else
#define ambientOfAll lightModel.ambient.rgb
#define eyeIsPlace (projectionMatrix[3][3] == 0.0)
#endif

#if defined(ONE_LIGHT)

const int numLights = 1;

Light lightAt(int place)
{
    return Light(sceneLight[0], sceneLight[1].rgb, sceneLight[2].rgb, sceneLight[3].rgb, sceneLight[4].xyz,
                 sceneLight[5].xyz, sceneLight[1].w, sceneLight[2].w, sceneLight[3].w);
}

#else

uniform int numLights;       // negative: lighting is off, and colours are shown unchanged
uniform int lightNumbers[8]; // the numbers of the enabled lights

Light lightAt(int place)
{
    int number = lightNumbers[place];
    return Light(lightSources[number].position, lightSources[number].ambient.rgb, lightSources[number].diffuse.rgb,
                 lightSources[number].specular.rgb,
                 vec3(lightSources[number].constantAttenuation, lightSources[number].linearAttenuation,
                      lightSources[number].quadraticAttenuation),
                 lightSources[number].spotDirection, lightSources[number].spotCutoff,
                 lightSources[number].spotCosCutoff, lightSources[number].spotExponent);
}

#endif

// The fraction of a light that reaches a point, after attenuation by distance and spotlight cone.
float attenuationOf(Light light, vec3 toLight)
{
    if (light.position.w == 0.0) return 1.0;
    float range = length(toLight);
    float attenuation = 1.0 / (light.attenuation.x + range * (light.attenuation.y + range * light.attenuation.z));
    if (light.spotCutoff > 90.0) return attenuation;
    float spot = dot(-toLight / range, normalize(light.spotDirection));
    if (spot < light.spotCosCutoff) return 0.0;
    return attenuation * pow(max(spot, 0.0), light.spotExponent);
}

vec3 towardsLight(Light light, vec3 eyePosition)
{
    return light.position.xyz - eyePosition * light.position.w;
}

vec3 towardsEye(vec3 eyePosition)
{
    return eyeIsPlace ? normalize(-eyePosition) : vec3(0.0, 0.0, 1.0);
}
