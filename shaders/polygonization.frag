// Polygonization, the light: Phong's model with the scene's lights, all by pixel.

in vec3 eyePosition;
in vec3 eyeNormal;
flat in uint color;

uniform int lights; // bit i: light i is on; below 0: lighting is off, and colours show as they are

const float SPECULAR = 0.1; // of the light; the rest is what colours scatter
const float SHININESS = 48.0;

float attenuationOf(gl_LightSourceParameters light, vec3 toLight)
{
    if (light.position.w == 0.0) return 1.0;
    float range = length(toLight);
    float attenuation = 1.0 / (light.constantAttenuation + range * (light.linearAttenuation +
                                                                    range * light.quadraticAttenuation));
    if (light.spotCutoff > 90.0) return attenuation;
    float spot = dot(-toLight / range, normalize(light.spotDirection));
    return spot < light.spotCosCutoff ? 0.0 : attenuation * pow(max(spot, 0.0), light.spotExponent);
}

void main()
{
    vec3 albedo = unpackUnorm4x8(color).rgb;
    if (lights < 0)
    {
        gl_FragColor = vec4(albedo, 1.0);
        return;
    }

    vec3 normal = normalize(gl_FrontFacing ? eyeNormal : -eyeNormal);
    vec3 toEye = gl_ProjectionMatrix[3][3] == 0.0 ? normalize(-eyePosition) : vec3(0.0, 0.0, 1.0);
    vec3 diffuse = gl_LightModel.ambient.rgb;
    vec3 specular = vec3(0.0);
    for (int index = 0; index < 8; ++index)
    {
        if ((lights & (1 << index)) == 0) continue;
        vec3 toLight = gl_LightSource[index].position.xyz - eyePosition * gl_LightSource[index].position.w;
        float attenuation = attenuationOf(gl_LightSource[index], toLight);
        vec3 direction = normalize(toLight);
        float cosine = dot(normal, direction);
        diffuse += attenuation * (gl_LightSource[index].ambient.rgb + max(cosine, 0.0) * gl_LightSource[index].diffuse.rgb);
        if (cosine <= 0.0) continue;
        float highlight = max(dot(reflect(-direction, normal), toEye), 0.0);
        specular += attenuation * pow(highlight, SHININESS) * gl_LightSource[index].specular.rgb;
    }
    gl_FragColor = vec4(mix(albedo * diffuse, specular, SPECULAR), 1.0);
}
