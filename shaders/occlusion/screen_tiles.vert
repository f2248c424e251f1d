// A pass over the tiles of the picture that show something, each drawn as a point. Software renderers run a shader to its end
// even where it discards its pixel at once, so empty parts of the picture are as expensive as others if they are drawn.

uniform sampler2D tiles; // for each tile, whether it shows anything
uniform ivec4 viewport;  // the lowest pixel, and the size in pixels
uniform ivec4 area;      // the lowest and highest pixels of the picture that may show something

flat out ivec4 tile; // its lowest pixel, and the pixel beyond its highest

void main()
{
    ivec2 first = area.xy / TILE;
    int across = area.z / TILE - first.x + 1;
    ivec2 place = first + ivec2(gl_VertexID % across, gl_VertexID / across);
    tile = ivec4(max(TILE * place, area.xy), min(TILE * (place + 1), area.zw + 1));
    // Points are clipped by their centres. Tiles at the upper borders are moved inwards, and shaders discard the overlap.
    vec2 size = vec2(viewport.zw);
    vec2 middle = vec2(TILE * place - viewport.xy) + 0.5 * float(TILE);
    middle = clamp(middle, min(vec2(0.5 * float(TILE)), 0.5 * size), max(size - 0.5 * float(TILE), 0.5 * size));
    gl_PointSize = float(TILE);
    bool isUsed = texelFetch(tiles, place, 0).r > 0.0;
    gl_Position = isUsed ? vec4(2.0 * middle / size - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
