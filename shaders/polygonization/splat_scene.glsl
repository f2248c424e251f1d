// What the shading of splats needs of the scene, handed to fragments as varyings that do not vary (#define PASSED flat out, or
// flat in): renderers in software read a uniform anew for every few pixels, in twenty instructions.

// Of rays, in cells: the change by pixels to the right and up, and their origin and direction in the picture's corner. Beside
// these: 1 where the direction changes, and 0 where the origin does; the height of a stud in cells; the range of depths.
PASSED vec4 sceneRays[4];
PASSED vec4 sceneEye;      // in cells: a place, or, where the last is 0, the direction towards it
PASSED ivec4 sceneNumbers; // the axis that is up, the picture's lower left pixel, the mode of the fog
PASSED vec4 sceneRows[3];  // from cells to the eye's coordinates
PASSED vec4 sceneNormals[3]; // columns of that for normals; beside them: the picture's size, and 0 in perspective
PASSED vec4 sceneFog[2];     // colour and density; end and scale
PASSED vec4 sceneAmbient;    // of all lights together
#if defined(ONE_LIGHT)
// The place; ambient, diffuse and specular; attenuation; the spot's direction. Beside these: its cutoff, the cosine of that,
// and its exponent.
PASSED vec4 sceneLight[6];
#endif
