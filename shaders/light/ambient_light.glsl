// Environment light: diffuse light from nine spherical harmonics (Ramamoorthi and Hanrahan 2001) or, with CONVOLVED_MAP, from
// a convolved map; reflections from maps that are filtered for each roughness.

#if defined(CONVOLVED_MAP)
uniform sampler2D convolvedMap;
#else
uniform vec3 irradiancePolynomial[9]; // see SphericalHarmonics
#endif
uniform sampler2D reflectionMap;
uniform float probeIntensity;
uniform mat3 worldToProbe;
uniform mat3 eyeToWorld;

const float REFLECTION_LEVELS = 6.0; // LightProbe::REFLECTION_LEVELS
const float PLASTIC = 0.04; // reflectance at normal incidence, for an index of refraction of 1.5

// The centre of the picture is the direction +y, the right half is towards +x, the top row towards +z.
vec2 toPicture(vec3 direction)
{
    const float PI = 3.14159265;
    float around = abs(direction.x) + abs(direction.y) > 0.0 ? atan(direction.x, direction.y) : 0.0;
    return vec2(0.5 + around / (2.0 * PI), 1.0 - acos(clamp(direction.z, -1.0, 1.0)) / PI);
}

#if defined(CONVOLVED_MAP)
// The poles are in the centres of the first and last row of the convolved map. This matters, since the normals of the
// tops of bricks point exactly at a pole.
vec2 toConvolved(vec3 direction)
{
    vec2 place = toPicture(direction);
    float rows = float(textureSize(convolvedMap, 0).y);
    return vec2(place.x, (0.5 + place.y * (rows - 1.0)) / rows);
}
#endif

vec3 toProbe(vec3 eyeDirection)
{
    return worldToProbe * (eyeToWorld * eyeDirection);
}

// Irradiance divided by pi: 1 if the radiance is 1 in all directions.
vec3 irradianceAt(vec3 eyeNormal)
{
    vec3 n = normalize(toProbe(eyeNormal));
#if defined(CONVOLVED_MAP)
    // The polynomial is not computed as well: software renderers would execute both branches.
    vec3 irradiance = textureLod(convolvedMap, toConvolved(n), 0.0).rgb;
#else
    vec3 irradiance = irradiancePolynomial[0] + irradiancePolynomial[1] * n.y + irradiancePolynomial[2] * n.z +
                      irradiancePolynomial[3] * n.x + irradiancePolynomial[4] * n.x * n.y +
                      irradiancePolynomial[5] * n.y * n.z + irradiancePolynomial[6] * (3.0 * n.z * n.z - 1.0) +
                      irradiancePolynomial[7] * n.x * n.z + irradiancePolynomial[8] * (n.x * n.x - n.y * n.y);
#endif
    return probeIntensity * max(irradiance, 0.0);
}

// The visibility in the mirrored direction, estimated from the visibility of the whole sky (Lagarde and de Rousiers 2014).
float reflectionVisibility(float cosine, float visibility, float roughness)
{
    return clamp(pow(cosine + visibility, exp2(-16.0 * roughness - 1.0)) - 1.0 + visibility, 0.0, 1.0);
}

// The light reflected by glossy plastic, with Karis' fit of the integrated reflectance (2014).
vec3 reflectionAt(vec3 eyeNormal, vec3 toEye, float roughness)
{
    float cosine = max(dot(eyeNormal, toEye), 0.0);
    vec3 direction = normalize(toProbe(reflect(-toEye, eyeNormal)));
    vec3 light = textureLod(reflectionMap, toPicture(direction), roughness * (REFLECTION_LEVELS - 1.0)).rgb;
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y;
    vec2 scale = vec2(-1.04, 1.04) * a + r.zw;
    return probeIntensity * light * (PLASTIC * scale.x + scale.y);
}
