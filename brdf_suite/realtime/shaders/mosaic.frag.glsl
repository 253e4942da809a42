// Provides: the flake mosaic of flake_grain.glsl: which of four tilts the flake at a place has, and how bright it is
// Needs:    CELLS, the flakes along an edge of the tile; size, its texels along an edge
//
// Every place shows one flake: the one whose seed is nearest, a seed to a cell. The tile repeats. A flake's brightness is
// 2.5 u^1.5, u even: of mean 1, for the depth it lies in; with the areas of the polygons, a flake's light has the
// second moment of FLAKE_AREA in sparkle_glints.glsl, 9/5.
#include "sparkle_hash.glsl"

uniform float size;

out vec4 fragment;

void main()
{
    vec2 at = gl_FragCoord.xy * (float(CELLS) / size);
    ivec2 cell = ivec2(floor(at));
    float nearest = 1e9;
    uint found = 0u;
    for (int i = 0; i < 25; ++i)
    {
        ivec2 other = cell + ivec2(i % 5 - 2, i / 5 - 2);
        uint key = cell_key((other + CELLS) % CELLS, 0x6d2b79f5u);
        vec2 apart = vec2(other) + halves(key) - at;
        float distance = dot(apart, apart);
        if (distance < nearest)
        {
            nearest = distance;
            found = key;
        }
    }
    uint word = scrambled(found + 0x9e3779b9u);
    float u = (float(word >> 8) + 0.5) * (1.0 / 16777216.0);
    fragment = 2.5 * u * sqrt(u) * vec4(equal(uvec4(word & 3u), uvec4(0u, 1u, 2u, 3u)));
}
