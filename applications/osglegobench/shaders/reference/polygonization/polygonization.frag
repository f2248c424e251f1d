// Polygonization, the plain look: Phong's lighting model per pixel, with the scene's lights.

#include "light/lighting.glsl"
#include "light/fog.glsl"

in vec3 eyePosition;
in vec3 eyeNormal;
flat in uint color;

const float SPECULAR = 0.1; // fraction of the light; the rest is diffuse
const float SHININESS = 48.0;

vec3 shade(vec3 albedo)
{
    if (numLights < 0) return albedo;
    vec3 normal = normalize(gl_FrontFacing ? eyeNormal : -eyeNormal);
    vec3 toEye = towardsEye(eyePosition);
    vec3 diffuse = gl_LightModel.ambient.rgb;
    vec3 specular = vec3(0.0);
    for (int light = 0; light < numLights; ++light)
    {
        int number = lightNumbers[light];
        vec3 toLight = towardsLight(number, eyePosition);
        float attenuation = attenuationOf(number, toLight);
        vec3 direction = normalize(toLight);
        float cosine = max(dot(normal, direction), 0.0);
        float highlight = cosine > 0.0 ? max(dot(reflect(-direction, normal), toEye), 0.0) : 0.0;
        diffuse += attenuation * (gl_LightSource[number].ambient.rgb + cosine * gl_LightSource[number].diffuse.rgb);
        specular += attenuation * pow(highlight, SHININESS) * gl_LightSource[number].specular.rgb;
    }
    return mix(albedo * diffuse, specular, SPECULAR);
}

void main()
{
    vec3 shaded = shade(unpackUnorm4x8(color).rgb);
    gl_FragColor = vec4(mix(gl_Fog.color.rgb, shaded, transmittanceAt(eyePosition.z)), 1.0);
}
