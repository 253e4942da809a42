// Provides: struct FlakeTexture, FlakeTexture flake_texture(...), vec3 flake_texture_ratio(FlakeTexture f, vec2 slope,
//           float spread), float flake_contrast(FlakeTexture f, float spread)
// Needs:    nothing. The same functions in numpy: tools/evaluation/flake_model.py
//
// The flake texture of Guenther et al. 2005, section 5.2: the cell of the texture coordinate seeds a generator, which
// draws the flake's normal from Beckmann's distribution with the paint's m,
//     theta = atan(m sqrt(-log(1 - r1))),   phi = 2 pi r2,
// and the flake is lit as a tiny mirror. One flake to a cell of 1/density, somewhere in it; the two by two cells about
// the point hold what a footprint sees, as long as it is no wider than a cell. Wider ones are held there, their contrast
// lowered as that of the mean of so many flakes would be, and faded out with distance before they alias.
//
// The result is the light of the flakes over their mean: 1 on the average of the surface.
#include "sparkle_hash.glsl"
#include "flake_footprint.glsl"
#include "flake_tilt.glsl"
#include "flake_tint.glsl"

// A flake is dropped from where fewer than this share of the top's flakes lie, and what it had stays smooth.
const float RAREST_TILT = 0.002;
// Widths of a footprint over a cell between which the texture fades out: about a pixel and a half, and four cells.
const float FADE_FROM = 0.75, FADE_TO = 2.0;

struct FlakeTexture
{
    vec4 cover;            // of the four flakes, times the area of a cell: 1 on the average
    vec4 slope_x, slope_y;
    vec3 tint[4];
    float roughness;
    float contrast;
    float height;          // of the largest cover there can be
};

FlakeTexture flake_texture(vec2 at, vec2 across, vec2 down, float density, float size, float roughness,
                           float colour_spread)
{
    FlakeTexture f;
    float per_mm = sqrt(density);
    Footprint whole = flake_footprint(at, across, down, size);
    // Held at half a cell's reach by shrinking the pixel's share, then the flake's.
    float most = 0.5 / (FOOTPRINT_END * per_mm);
    float held = min(size, 4.0 * most);
    float own = 0.25 * held;
    float pixel2 = max(whole.widest * whole.widest - 0.0625 * size * size, 0.0);
    float shrink = pixel2 > 0.0 ? sqrt(clamp((most * most - own * own) / pixel2, 0.0, 1.0)) : 1.0;
    Footprint kept = flake_footprint(at, across * shrink, down * shrink, held);
    f.contrast = min(sqrt(kept.height > 0.0 ? whole.height / kept.height : 1.0), 1.0)
        * (1.0 - smoothstep(FADE_FROM, FADE_TO, whole.widest * per_mm));
    f.roughness = roughness;
    f.height = kept.height / density;

    vec2 on_surface = at * per_mm;
    vec2 first = floor(on_surface - 0.5);
    for (int i = 0; i < 4; ++i)
    {
        vec2 cell = first + vec2(i & 1, i >> 1);
        uint key = cell_key(ivec2(cell), 0x51ed270bu);
        vec2 centre = (cell + halves(scrambled(key + 0x9e3779b9u))) / per_mm;
        f.cover[i] = flake_cover(kept, at - centre) / density;
        vec2 r = halves(key);
        float tangent = roughness * sqrt(-log(1.0 - r.x));
        f.slope_x[i] = tangent * cos(6.2831853 * r.y);
        f.slope_y[i] = tangent * sin(6.2831853 * r.y);
        f.tint[i] = flake_tint(scrambled(key + 0x3c6ef372u), colour_spread);
    }
    return f;
}

// The contrast in one light, as glint_contrast, for tilts along the normal.
float flake_contrast(FlakeTexture f, float spread)
{
    return f.contrast * sqrt(0.74 * f.height * (f.roughness * f.roughness + 2.0 * spread * spread) * 0.225) / spread;
}

vec3 flake_texture_ratio(FlakeTexture f, vec2 slope, float spread)
{
    vec4 dx = f.slope_x - slope.x, dy = f.slope_y - slope.y;
    float narrow = 1.0 / (8.0 * spread * spread);
    vec4 bell = max(1.0 - (dx * dx + dy * dy) * narrow, 0.0);
    vec4 seen = f.cover * bell * bell * (3.0 * 0.31830989 * narrow);
    // The mean of the bells over all flakes: Beckmann's slopes, of the variance m^2/2 along an axis, widened by a bell.
    float wide = sqrt(f.roughness * f.roughness + 2.0 * spread * spread);
    float mean = beckmann_slopes(dot(slope, slope), wide);
    float top = RAREST_TILT * beckmann_slopes(0.0, wide);
    vec3 sum = seen.x * f.tint[0] + seen.y * f.tint[1] + seen.z * f.tint[2] + seen.w * f.tint[3];
    return 1.0 + (sum - mean) / max(mean, top) * f.contrast;
}
