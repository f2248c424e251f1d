// The state that GL's compatibility profile keeps for shaders. The core profile has none of it: there, the class FixedState
// sets uniforms of the same meaning.

#ifndef OSGLEGO_FIXED_STATE
#define OSGLEGO_FIXED_STATE

#if !defined(OSGLEGO_CORE_PROFILE)

#define modelViewMatrix gl_ModelViewMatrix
#define projectionMatrix gl_ProjectionMatrix
#define modelViewProjectionMatrix gl_ModelViewProjectionMatrix
#define eyeNormalMatrix gl_NormalMatrix
#define lightSources gl_LightSource
#define lightModel gl_LightModel
#define fogParameters gl_Fog
#define frontMaterial gl_FrontMaterial

#else

struct LightSource
{
    vec4 ambient;
    vec4 diffuse;
    vec4 specular;
    vec4 position; // in eye coordinates, as the direction
    vec3 spotDirection;
    float spotExponent;
    float spotCutoff; // degrees
    float spotCosCutoff;
    float constantAttenuation;
    float linearAttenuation;
    float quadraticAttenuation;
};

struct LightModel
{
    vec4 ambient;
};

struct FogParameters
{
    vec4 color;
    float density;
    float end;
    float scale; // 1 / (end - start)
};

struct Material
{
    vec4 specular;
    float shininess;
};

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat4 modelViewProjectionMatrix;
uniform mat3 eyeNormalMatrix;
uniform LightSource lightSources[8];
uniform LightModel lightModel;
uniform FogParameters fogParameters;
uniform Material frontMaterial;
#if defined(CLIP_PLANES)
uniform vec4 clipPlanes[8]; // in eye coordinates; see class CoreClipPlanes
#endif

#endif

#endif
