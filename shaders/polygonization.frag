// Polygonization, the light: Phong's model with the scene's lights, all by pixel.

in vec3 eyePosition;
in vec3 eyeNormal;
flat in uint color;

uniform int numLights;       // below 0: lighting is off, and colours show as they are
uniform int lightNumbers[8]; // of the lights that are on

const float SPECULAR = 0.1; // of the light; the rest is what colours scatter
const float SHININESS = 48.0;

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

void main()
{
    vec3 albedo = unpackUnorm4x8(color).rgb;
    if (numLights < 0)
    {
        gl_FragColor = vec4(albedo, 1.0);
        return;
    }

    vec3 normal = normalize(gl_FrontFacing ? eyeNormal : -eyeNormal);
    vec3 toEye = gl_ProjectionMatrix[3][3] == 0.0 ? normalize(-eyePosition) : vec3(0.0, 0.0, 1.0);
    vec3 diffuse = gl_LightModel.ambient.rgb;
    vec3 specular = vec3(0.0);
    for (int light = 0; light < numLights; ++light)
    {
        int number = lightNumbers[light];
        vec3 toLight = gl_LightSource[number].position.xyz - eyePosition * gl_LightSource[number].position.w;
        float attenuation = attenuationOf(number, toLight);
        vec3 direction = normalize(toLight);
        float cosine = max(dot(normal, direction), 0.0);
        float highlight = cosine > 0.0 ? max(dot(reflect(-direction, normal), toEye), 0.0) : 0.0;
        diffuse += attenuation * (gl_LightSource[number].ambient.rgb + cosine * gl_LightSource[number].diffuse.rgb);
        specular += attenuation * pow(highlight, SHININESS) * gl_LightSource[number].specular.rgb;
    }
    gl_FragColor = vec4(mix(albedo * diffuse, specular, SPECULAR), 1.0);
}
