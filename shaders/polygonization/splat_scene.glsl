// The values of the scene needed for shading splats, passed to fragments as flat varyings (#define PASSED flat out, or flat
// in): software renderers read a uniform again for every few pixels, which takes twenty instructions.

// xyz: the changes of rays per pixel to the right and up, and the origin and direction of the ray at the picture's corner, in
// cells. w: 1 if the direction changes from pixel to pixel, 0 if the origin does; the height of a stud in cells; the start and
// size of the depth range.
PASSED vec4 sceneRays[4];
PASSED vec4 sceneEye;      // in cells: the position or, if w is 0, the direction towards the eye
PASSED ivec4 sceneNumbers; // the up axis, the picture's lower left pixel, the fog mode
PASSED ivec3 sceneSplats;  // the number of the first brick's splat, the numbers of splats and of bricks with known neighbours
PASSED vec4 sceneRows[3];  // the matrix from cells to eye coordinates
PASSED vec4 sceneNormals[3]; // xyz: the columns of the normal matrix; w: the picture's width and height, and 0 in perspective
PASSED vec4 sceneFog[2];     // colour and density; end and scale
PASSED vec4 sceneAmbient;    // lightModel.ambient
#if defined(GRID_OCCLUSION)
PASSED vec2 sceneCellWidth; // see near_occlusion.glsl: cellPixelWidth
#endif
#if defined(DISTANT_OCCLUSION)
// See distant_occlusion.glsl. xyz: from cells to texture coordinates, the scale and the offset; the extent of a voxel. w:
// pixelWidth; 1 with hasFaceOcclusion, and 1 more with includesNear.
PASSED vec4 sceneVoxels[3];
#if defined(PARTIAL)
PASSED float sceneShare; // distantShare
#endif
#endif
#if defined(LINES)
PASSED vec4 sceneLines; // see part_lines.glsl: the widths of lines and of those on faded parts, and that of a pixel
#endif
#if defined(ONE_LIGHT)
// The position; ambient, diffuse and specular colour; attenuation; spotlight direction. The alphas of the colours: spotlight
// cutoff, the cosine of the cutoff, and the exponent.
PASSED vec4 sceneLight[6];
#endif
