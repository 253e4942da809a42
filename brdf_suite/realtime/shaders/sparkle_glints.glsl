// Provides: struct GlintField, GlintField glint_field(...), float glint_contrast(GlintField g, float width),
//           MOST_GLINT_LIGHTS, glint_widths, glint_places, glint_powers, vec3 glint_difference(GlintField g, int count),
//           vec3 glint_ratio(GlintField g, vec3 place, float spread), float shown_share(float weight)
// Needs:    nothing. The same functions in numpy: tools/evaluation/flake_model.py
//
// How bright the visible flakes of a footprint are in one light, over their mean: 1 for endlessly many, mostly 0 and
// sometimes very much for a few. After Kemppinen et al., "Glinty NDFs in Constant Time" (SIGGRAPH Asia 2025).
//
// A flake has a place on the surface and a place on the unit square of tilts (flake_tilt.glsl), N flakes to the square
// millimetre. On level l both are cut into cells, 2^l / sqrt(N) mm wide on the surface and 2^-l on the square, so a
// pair of cells holds one flake, jittered within both by a hash. The level is such that a footprint ends within two
// cells along each axis: two by two cells about the corner nearest to it hold all it sees, and so it is on the square.
// Between levels flakes of one appear, one after the other, while those of the other go: their number, and so the
// contrast, stays.
//
// What differs from the paper. The kernels end (they are no Gaussians), within the cells that are visited: nothing is
// cut off, no remainder has to be added, and the mean is 1 exactly. Cells of tilts are never made smaller than a
// flake's own spread (level `finest`): beyond it, a pair of cells holds many flakes, and one represents M of them; the
// sum of M has the deviation from the mean of one over sqrt(M). A light too broad for the cells is one of a smaller
// spread with the contrast lowered in the same way. So contrast falls with the root of the count everywhere.
// And the flakes of a cell on the surface share their place in it: at most one of them is seen at a time, and the
// places that a footprint covers are then the same for all lights, are few, and are found once.
//
// Where one flake would represent many, how many of a pixel's flakes are lit is drawn instead (lit_flakes). The two are
// mixed by weights of the sum 1, so nothing becomes negative; the counted ones are so much fewer that the contrast stays.
#include "sparkle_hash.glsl"
#include "flake_footprint.glsl"
#include "flake_tilt.glsl"
#include "flake_tint.glsl"

// Flakes of a level appear over this range of its weight.
const float APPEARING = 0.2;
// Flakes are of different areas: 3 u^2 of the mean, u even, so most are small and the largest have three times the
// mean.
const float FLAKE_AREA = 3.0;

struct GlintField
{
    Footprint footprint;
    float level;           // not whole
    float root_count;      // sqrt(N), 1/mm
    float finest;          // level of the smallest cells of tilts, whole
    float colour_spread;   // 0 to 1
};

// density: flakes per mm^2; size: mm; roughness: of the tilts; waviness: of one flake, rad. The disc of tilts is pi/4
// of the square, so N is 4/pi of the density. across, down: derivatives of `at` in mm per pixel.
GlintField glint_field(vec2 at, vec2 across, vec2 down, float density, float size, float roughness,
                       float waviness, float colour_spread)
{
    GlintField g;
    g.footprint = flake_footprint(at, across, down, size);
    g.root_count = sqrt(1.27323954 * density);
    g.level = max(log2(4.0 * FOOTPRINT_END * g.footprint.widest * g.root_count), 0.0);
    g.finest = max(floor(log2(roughness / (FOOTPRINT_END * waviness))), 0.0);
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

// Lights that are to glint in this pixel: the place on the square of the tilt that mirrors each to the eye, the
// standard deviation there over which a flake still does, and the light that is to be multiplied.
const int MOST_GLINT_LIGHTS = 24;
vec2 glint_places[MOST_GLINT_LIGHTS];
float glint_widths[MOST_GLINT_LIGHTS];
vec3 glint_powers[MOST_GLINT_LIGHTS];

// The contrast of the glints in one light, their standard deviation over their mean. Flakes lie by chance, so its
// square is the integral of a flake's kernels squared over N: of the bell 9 / (40 pi width^2), of the cover 26/35 of
// its height, of the areas 9/5.
float glint_contrast(GlintField g, float width)
{
    return sqrt(0.095765 * g.footprint.height) / (width * g.root_count);
}

// What the flakes of one place send.
vec3 glints_of_place(GlintField g, int count, uint key, float weight, float per_square)
{
    vec3 sum = vec3(0.0);
    float widest = 0.5 / (FOOTPRINT_END * per_square);
    for (int k = 0; k < count; ++k)
    {
        float sigma = min(glint_widths[k], widest);
        float narrow = 1.0 / (8.0 * sigma * sigma);
        float falls = narrow / (per_square * per_square);
        vec2 on_square = glint_places[k] * per_square;
        vec2 first = floor(on_square - 0.5);
        on_square -= first;
        uint mixed = key + uint(int(first.x) * 0x3c6ef35f + int(first.y) * 0x19660d);
        uvec4 word = uvec4(scrambled(mixed), scrambled(mixed + 0x3c6ef35fu), scrambled(mixed + 0x19660du),
                           scrambled(mixed + 0x3c6ef35fu + 0x19660du));
        vec4 x = on_square.x - vec4(0.0, 1.0, 0.0, 1.0) - (vec4(word & 0xffffu) + 0.5) * (1.0 / 65536.0);
        vec4 y = on_square.y - vec4(0.0, 0.0, 1.0, 1.0) - (vec4(word >> 16) + 0.5) * (1.0 / 65536.0);
        vec4 bell = max(1.0 - (x * x + y * y) * falls, 0.0);
        // Mostly none of the four is seen. A loop whose end the compiler does not know is then left after one round; a
        // `continue` spares a software renderer nothing.
        int cells = bell.x + bell.y + bell.z + bell.w > 0.0 ? 4 : 0;
        vec3 tinted = vec3(0.0);
        for (int j = 0; j < cells; ++j)
        {
            if (bell[j] <= 0.0)
                continue;
            uint other = scrambled(word[j] + 0x9e3779b9u);
            float area = (float((other >> 8) & 0xffu) + 0.5) * (1.0 / 256.0);
            float seen = bell[j] * bell[j] * area * area
                * shown((float(other & 0xffu) + 0.5) * (1.0 / 256.0), weight);
            tinted += g.colour_spread > 0.0 ? seen * flake_tint(other, g.colour_spread) : vec3(seen);
        }
        sum += (FLAKE_AREA * narrow * sigma / glint_widths[k]) * glint_powers[k] * tinted;
    }
    return sum;
}

// A level's cells: how many to a unit of the square and to a millimetre, and what contrast is left where a pair of
// cells holds many flakes.
struct GlintLevel
{
    float number, weight, per_square, per_mm, contrast;
};

GlintLevel glint_level(GlintField g, int above)
{
    float level = floor(g.level) + float(above);
    float angular = min(level, g.finest);
    return GlintLevel(level, 1.0 - abs(g.level - level), exp2(angular), g.root_count * exp2(-level),
                      exp2(angular - level));
}

// Cells of the surface in which lit flakes are counted: their edge over the footprint's standard deviation, from half of
// this to twice. How far above the finest level, and above LEAST_COUNTED, that begins, and within how many levels.
const float COUNT_CELL = 2.5;
// Cells of a pixel's size lie askew, so that no bands are seen where they and the pixels nearly agree.
const mat2 COUNT_TURN = mat2(0.8, 0.6, -0.6, 0.8);
const float LEAST_COUNTED = 2.0, COUNTED_FROM = 0.3, COUNTED_WITHIN = 0.5;
const float AREA_MOMENT = 1.8;     // mean square of FLAKE_AREA u^2

// How much of the light is of flakes that are drawn one by one; the rest is of counted ones.
float drawn_singly(GlintField g)
{
    float above = g.level - max(g.finest, LEAST_COUNTED) - COUNTED_FROM;
    return 1.0 - clamp(above / COUNTED_WITHIN, 0.0, 1.0);
}

// What a cell sends over its mean, for numbers in (0, 1), even, where `lit` of its flakes are lit on the average: of
// the mean 1 and the variance AREA_MOMENT / lit. Few are: with a chance of about `lit`, by one of them, of its area.
// Many are: always, with the area's deviation made smaller.
vec4 lit_flakes(vec4 even, float lit)
{
    float chance = min(lit * AREA_MOMENT / (AREA_MOMENT + lit), 1.0);
    float deviation = min(1.5 * inversesqrt(lit), 1.0);
    vec4 u = max(1.0 - even / chance, 0.0);
    return 1.0 + deviation * (FLAKE_AREA / chance * u * u - 1.0);
}

// The mean of that over four tilts, by their weights. A key has been scrambled, so half of that is enough.
float lit_cell(uint key, vec4 tilts, float lit)
{
    uvec4 word = key + uvec4(0u, 0x3c6ef35fu, 0x19660du, 0x3c6ef35fu + 0x19660du);
    word = (word ^ (word >> 16u)) * 0x21f0aaadu;
    return dot(tilts, lit_flakes((vec4(word >> 8u) + 0.5) * (1.0 / 16777216.0), lit));
}

vec4 bilinear(vec2 at)
{
    vec2 less = 1.0 - at;
    return vec4(less.x * less.y, at.x * less.y, less.x * at.y, at.x * at.y);
}

// The sum over the lights of power times (ratio - 1), of lit flakes counted in cells of about a pixel's size and of a
// flake's spread of tilts, on two levels. Between them it is interpolated: the weights' sum of squares tells by how much
// fewer flakes a cell has to have for the sum to have the footprint's variance. `fewer`: by how much besides.
vec3 counted_difference(GlintField g, int count, float fewer)
{
    float level = max(log2(COUNT_CELL * g.footprint.widest * g.root_count), 0.0);
    float low = floor(level);
    float per_square = exp2(g.finest + 1.0);
    uvec4 keys[2];
    mat4x3 cells[2];      // weight times tint of each
    float squares = 0.0;
    for (int above = 0; above < 2; ++above)
    {
        vec2 at = COUNT_TURN * g.footprint.at * (g.root_count * exp2(-low - float(above))) - 0.5;
        vec2 first = floor(at);
        vec4 weight = (1.0 - abs(level - low - float(above))) * bilinear(at - first);
        squares += dot(weight, weight);
        uint salt = uint(int(low) + above) * 0x9e3779b9u + 0x51ed270bu;
        uvec2 row = uvec2(scrambled(uint(int(first.y)) + salt), scrambled(uint(int(first.y) + 1) + salt));
        keys[above] = scrambled(uint(int(first.x)) + uvec4(0u, 1u, 0u, 1u) + row.xxyy);
        cells[above] = mat4x3(weight.xxx, weight.yyy, weight.zzz, weight.www);
        int tinted = g.colour_spread > 0.0 ? 4 : 0;
        for (int j = 0; j < tinted; ++j)
            cells[above][j] *= flake_tint(keys[above][j], g.colour_spread);
    }
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; ++k)
    {
        vec2 on_square = glint_places[k] * per_square - 0.5;
        vec2 first = floor(on_square);
        vec4 tilts = bilinear(on_square - first);
        float contrast = glint_contrast(g, glint_widths[k]);
        float lit = fewer * AREA_MOMENT * squares * dot(tilts, tilts) / (contrast * contrast);
        uint mixed = uint(int(first.x) * 0x3c6ef35f + int(first.y) * 0x19660d);
        vec3 ratio = vec3(0.0);
        int levels = lit > 0.0 ? 2 : 0;
        for (int above = 0; above < levels; ++above)
        {
            uvec4 key = (above == 0 ? keys[0] : keys[1]) + mixed;
            ratio += (above == 0 ? cells[0] : cells[1])
                * vec4(lit_cell(key.x, tilts, lit), lit_cell(key.y, tilts, lit), lit_cell(key.z, tilts, lit),
                       lit_cell(key.w, tilts, lit));
        }
        sum += glint_powers[k] * (ratio - 1.0);
    }
    return sum;
}

// The same of flakes drawn one by one.
vec3 single_difference(GlintField g, int count)
{
    // Two levels of two by two cells, in one loop whose end the compiler does not know: written out eight times over, a
    // software renderer takes seconds to compile it. The places that the footprint covers are found first, since it
    // also carries out for all of its pixels what one of them needs.
    int pairs = count > 0 ? 8 : 0;
    int covered = 0;
    int above[8];
    uint keys[8];
    float covers[8];
    for (int i = 0; i < pairs; ++i)
    {
        GlintLevel l = glint_level(g, i >> 2);
        vec2 on_surface = g.footprint.at * l.per_mm;
        vec2 cell = floor(on_surface - 0.5) + vec2(i & 1, (i >> 1) & 1);
        vec2 gap = abs(on_surface - cell - 0.5) - 0.5;
        if (l.weight <= 0.0 || any(greaterThanEqual(gap, g.footprint.reach * l.per_mm)))
            continue;
        uint key = cell_key(ivec2(cell), uint(int(l.number)) * 0x9e3779b9u);
        float cover = flake_cover(g.footprint, (on_surface - cell - halves(scrambled(key))) / l.per_mm);
        if (cover <= 0.0)
            continue;
        above[covered] = i >> 2;
        keys[covered] = key;
        covers[covered] = cover;
        ++covered;
    }
    vec3 sum = vec3(0.0);
    for (int i = 0; i < covered; ++i)
    {
        GlintLevel l = glint_level(g, above[i]);
        // A flake represents its pair of cells: 1 / (per_mm per_square)^2 of surface and square.
        float stands_for = 1.0 / (l.per_mm * l.per_mm * l.per_square * l.per_square);
        sum += glints_of_place(g, count, keys[i], l.weight, l.per_square)
            * (0.95492966 * stands_for * l.contrast * covers[i]);
    }
    GlintLevel low = glint_level(g, 0), high = glint_level(g, 1);
    float low_mean = shown_share(low.weight) * low.contrast, high_mean = shown_share(high.weight) * high.contrast;
    float low_widest = 0.5 / (FOOTPRINT_END * low.per_square), high_widest = 0.5 / (FOOTPRINT_END * high.per_square);
    for (int k = 0; k < count; ++k)
        sum -= glint_powers[k] * (low_mean * min(low_widest / glint_widths[k], 1.0)
                                  + high_mean * min(high_widest / glint_widths[k], 1.0));
    return sum;
}

// The sum over the lights of power times (ratio - 1).
vec3 glint_difference(GlintField g, int count)
{
    float single = drawn_singly(g);
    vec3 sum = vec3(0.0);
    if (single > 0.0)
        sum += single * single_difference(g, count);
    if (single < 1.0)
        sum += (1.0 - single) * counted_difference(g, count, (1.0 - single) / (1.0 + single));
    return sum;
}

// For one light: place of flake_tilt.glsl; spread: standard deviation of tilt over which a flake still mirrors it, rad.
vec3 glint_ratio(GlintField g, vec3 place, float spread)
{
    glint_places[0] = place.xy;
    glint_widths[0] = place.z * spread;
    glint_powers[0] = vec3(1.0);
    return 1.0 + glint_difference(g, 1);
}
