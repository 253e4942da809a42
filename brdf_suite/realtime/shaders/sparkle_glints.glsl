// Provides: struct GlintField, GlintField glint_field(...), vec3 glint_ratio(GlintField g, vec3 place, float spread),
//           float shown_share(float weight)
// Needs:    nothing. The same functions in numpy: reflectance/flakes/glints.py
//
// How bright the countable flakes of a footprint are in one light, over their mean: 1 for endlessly many, mostly 0 and
// sometimes very much for a few. After Kemppinen et al., "Glinty NDFs in Constant Time" (SIGGRAPH Asia 2025).
//
// A flake has a place on the surface and a place on the unit square of tilts (flake_tilt.glsl), N flakes to the square
// millimetre. On level l both are cut into cells, 2^l / sqrt(N) mm wide on the surface and 2^-l on the square, so a pair
// of cells holds one flake, jittered within both by a hash of the pair. The level is such that a footprint
// ends within two cells along each axis: two by two cells about the corner nearest to it hold all it sees, on
// either side. Between levels flakes of one appear, one after the other, while those of the other go: their
// number, and so the contrast, stays.
//
// What differs from the paper. The kernels end (they are no Gaussians), within the cells that are visited: nothing is cut
// off, no remainder has to be added, and the mean is 1 exactly. Cells of tilts are never made smaller than a flake's
// own spread (level `finest`): beyond it, a pair of cells holds many flakes, and one stands for M of them; the
// sum of M has the deviation from the mean of one over sqrt(M). A light too broad for the cells is one of a smaller
// spread with the contrast lowered in the same way. So contrast falls with the root of the count everywhere.
#include "sparkle_hash.glsl"
#include "flake_footprint.glsl"
#include "flake_tilt.glsl"
#include "flake_tint.glsl"

// Flakes of a level appear over this range of its weight.
const float APPEARING = 0.2;

struct GlintField
{
    Footprint footprint;
    float level;           // not whole
    float root_count;      // sqrt(N), 1/mm
    float finest;          // level of the smallest cells of tilts, whole
    float colour_spread;   // 0 to 1
};

// density: flakes per mm^2; size: mm; roughness: of the tilts; waviness: of one flake, rad. The disc of tilts is pi/4 of
// the square, so N is 4/pi of the density. across, down: derivatives of `at` in mm per pixel.
GlintField glint_field(vec2 at, vec2 across, vec2 down, float density, float size, float roughness,
                       float waviness, float colour_spread)
{
    GlintField g;
    g.footprint = flake_footprint(at, across, down, size);
    g.root_count = sqrt(1.27323954 * density);
    g.level = max(log2(4.0 * FOOTPRINT_END * g.footprint.widest * g.root_count), 0.0);
    g.finest = max(floor(log2(roughness / (2.0 * 0.35355339 * FOOTPRINT_END * waviness))), 0.0);
    g.colour_spread = colour_spread;
    return g;
}

// The share of a level's flakes that is shown at its weight: they come evenly from APPEARING/2 to 1 - APPEARING/2, each
// by a smoothstep of the width APPEARING about its own. The mean of those, in closed form: with
// i(s) = s^3 - s^4/2 up to s = 1, then s - 1/2, the integral of smoothstep.
float shown_share(float weight)
{
    float low = weight / APPEARING;
    float high = max(low + 1.0 - 1.0 / APPEARING, 0.0);
    float first = low < 1.0 ? low * low * low * (1.0 - 0.5 * low) : low - 0.5;
    float last = high * high * high * (1.0 - 0.5 * high);
    return (first - last) * (APPEARING / (1.0 - APPEARING));
}

float shown(float order, float weight)
{
    float middle = 0.5 * APPEARING + (1.0 - APPEARING) * order;
    return smoothstep(middle - 0.5 * APPEARING, middle + 0.5 * APPEARING, weight);
}

vec3 glints_of_level(GlintField g, float level, float weight, vec3 place, float spread)
{
    float angular = min(level, g.finest);
    float per_square = exp2(angular);
    float per_mm = g.root_count * exp2(-level);
    float wanted = place.z * spread;
    float sigma = min(wanted, 0.5 / (FOOTPRINT_END * per_square));
    float contrast = exp2(angular - level) * sigma / wanted;

    vec2 on_surface = g.footprint.at * per_mm;
    vec2 on_square = place.xy * per_square;
    vec2 first_cell = floor(on_surface - 0.5);
    vec2 first_tilt = floor(on_square - 0.5);
    vec2 reach = g.footprint.reach * per_mm;
    float tilt_reach = FOOTPRINT_END * sigma * per_square;
    uint salt = uint(int(level)) * 0x9e3779b9u;
    float narrow = 1.0 / (8.0 * sigma * sigma);

    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i)
    {
        vec2 cell = first_cell + vec2(i & 1, i >> 1);
        vec2 gap = abs(on_surface - cell - 0.5) - 0.5;
        if (any(greaterThanEqual(gap, reach)))
            continue;
        uint key = cell_key(ivec2(cell), salt);
        for (int j = 0; j < 4; ++j)
        {
            vec2 tilt = first_tilt + vec2(j & 1, j >> 1);
            vec2 tilt_gap = abs(on_square - tilt - 0.5) - 0.5;
            if (max(tilt_gap.x, tilt_gap.y) >= tilt_reach)
                continue;
            uint word = scrambled(key + uint(int(tilt.x) * 0x3c6ef35f + int(tilt.y) * 0x19660d));
            vec2 apart = place.xy - (tilt + halves(word)) / per_square;
            float bell = 1.0 - dot(apart, apart) * narrow;
            if (bell <= 0.0)
                continue;
            uint other = scrambled(word + 0x9e3779b9u);
            float cover = flake_cover(g.footprint, g.footprint.at - (cell + halves(other)) / per_mm);
            if (cover <= 0.0)
                continue;
            uint third = scrambled(other + 0x9e3779b9u);
            float seen = bell * bell * cover * shown(float(third & 0xffu) * (1.0 / 255.0), weight);
            sum += seen * flake_tint(third, g.colour_spread);
        }
    }
    // A flake stands for its pair of cells: 1 / (per_mm per_square)^2 of surface and square.
    float scale = 3.0 * narrow * 0.31830989 / (per_mm * per_mm * per_square * per_square);
    float mean = shown_share(weight);
    return mean + (sum * scale - mean) * contrast;
}

// place: of flake_tilt.glsl; spread: standard deviation of tilt over which one flake still mirrors the light, rad.
vec3 glint_ratio(GlintField g, vec3 place, float spread)
{
    float level = floor(g.level);
    float rest = g.level - level;
    vec3 ratio = glints_of_level(g, level, 1.0 - rest, place, spread);
    if (rest > 0.0)
        ratio += glints_of_level(g, level + 1.0, rest, place, spread);
    return ratio;
}
