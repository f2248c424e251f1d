// The scene's lights, as osg::Light describes them.

uniform int numLights;       // below 0: lighting is off, and colours show as they are
uniform int lightNumbers[8]; // of the lights that are on

// How much of a light comes to a place, by distance and spot.
float attenuationOf(int number, vec3 toLight)
{
    if (gl_LightSource[number].position.w == 0.0) return 1.0;
    float range = length(toLight);
    float attenuation =
        1.0 / (gl_LightSource[number].constantAttenuation +
               range * (gl_LightSource[number].linearAttenuation + range * gl_LightSource[number].quadraticAttenuation));
    if (gl_LightSource[number].spotCutoff > 90.0) return attenuation;
    float spot = dot(-toLight / range, normalize(gl_LightSource[number].spotDirection));
    if (spot < gl_LightSource[number].spotCosCutoff) return 0.0;
    return attenuation * pow(max(spot, 0.0), gl_LightSource[number].spotExponent);
}

vec3 towardsLight(int number, vec3 eyePosition)
{
    return gl_LightSource[number].position.xyz - eyePosition * gl_LightSource[number].position.w;
}

vec3 towardsEye(vec3 eyePosition)
{
    return gl_ProjectionMatrix[3][3] == 0.0 ? normalize(-eyePosition) : vec3(0.0, 0.0, 1.0);
}
