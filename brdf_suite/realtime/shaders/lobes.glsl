// Provides: vec3 reflected_radiance(SurfacePoint p): equations 7 to 9 of the paper, and the same look-ups shifted
// Needs:    surface_point.glsl, ramp.glsl; BROAD (look-ups; 0: as many as the material says), SHARP, FOR_EACH_SHARP_LOBE (written
//           by shader_source.py); MAX_BROAD, MAX_SHARP, RAMP_ROWS, RAMP_NODES; LOOK_UP_PAPER for the paper's form
//
// With P_E the unit-gain map of exponent E, R the mirror direction of the view about N, c = N.V = N.R:
//     Lo =  pi KD P_1(N)                                       equation 9: the diffuse map looked up at N
//         + sum KDD_i 2 pi/(E_i+1) P_i(R) (N.R)                equation 7: the light direction is taken as R
//         + sum KG_i  2 pi/(E_i+1) P_i(R)                      equation 8
// or, with direction, exponent and amplitude of the look-ups from a table (docs/method/shading.md),
//         + sum KDD_i A_i(c) P_e(R + b_i(c) N),  e = e_i(c)    and so on,
//         + sum BACK_i A_i(c) P_e(V + b_i(c) N)                light that is sent back, V = 2 c N - R
// Weights, amplitudes, exponents and Fresnel's gains depend on c alone: the ramp of a material has them over the root
// of c, a row for each look-up (material/ramp.py). What differs between the modes are its numbers.
//
// The numbers of look-ups are constants of the program: a software renderer takes half as long again for a loop that is
// not written out, and carries out both sides of a condition. Where a material has fewer, the rest weighs nothing.
#include "ramp.glsl"
#include "occlusion.glsl"
#include "environment.glsl"
#include "lobe_stack.glsl"

// OpenGL 3.3 allows arrays of samplers to be indexed by constants only, so that loop is written out.
uniform samplerCube sharp_maps[SHARP];
uniform vec3 sharp_lobes[SHARP];        // scale of the map, log2(texels per radian), exponent

// Where a broad lobe is looked up: beside R towards N or away from it, or beside V; not normalized. In the paper's
// form at R.
vec3 looked_at(vec3 r, vec3 n, float c, vec4 b)
{
#ifdef LOOK_UP_PAPER
    return r;
#else
    return (b.w < 0.0 ? -r : r) + (b.x + c * (b.y + c * b.z)) * n;
#endif
}

#if defined(COAT_RELIEF)
#define FIRST_LOOK_UPS look_ups.x
#elif BROAD > 0
#define FIRST_LOOK_UPS BROAD
#else
#define FIRST_LOOK_UPS look_ups.y
#endif

// What of relief is too fine for a pixel makes lobes wider.
#ifdef NORMAL_MAP
#define WIDENED(level, exponent) widened(level, exponent, p.base_spread)
#else
#define WIDENED(level, exponent) level
#endif

#ifdef OCCLUSION
#define ARRIVES(c, exponent) * specular_occlusion(c, p.occlusion, exponent)
#else
#define ARRIVES(c, exponent)
#endif

vec3 reflected_radiance(SurfacePoint p)
{
    float c = seen_cosine(p);
    vec3 n = to_environment(p.normal);
    vec3 r = to_environment(2.0 * dot(p.normal, p.view) * p.normal - p.view);
    float x = ramp_coordinate(c);

    vec4 row = ramp_row(x, 0);
    vec3 radiance = row.rgb * broad_light(to_environment(p.bent), row.a);
#ifdef OCCLUSION
    radiance *= p.occlusion;
#endif
    for (int k = 0; k < FIRST_LOOK_UPS; ++k)
    {
        row = ramp_row(x, 1 + MAX_SHARP + k);
        radiance += row.rgb * broad_light(looked_at(r, n, c, broad[k]), WIDENED(row.a, abs(broad[k].w)))
            ARRIVES(c, abs(broad[k].w));
    }
#ifdef COAT_RELIEF
    // The coat stands otherwise than the base.
    c = max(dot(p.coat_normal, p.view), finest_cosine(p));
    n = to_environment(p.coat_normal);
    r = to_environment(2.0 * dot(p.coat_normal, p.view) * p.coat_normal - p.view);
    x = ramp_coordinate(c);
    for (int k = look_ups.x; k < look_ups.y; ++k)
    {
        row = ramp_row(x, 1 + MAX_SHARP + k);
        radiance += row.rgb * broad_light(looked_at(r, n, c, broad[k]), widened(row.a, abs(broad[k].w), p.coat_spread))
            ARRIVES(c, abs(broad[k].w));
    }
#endif
    // How far the mirror direction turns from pixel to pixel, in radians; in texels of a map it is 2^level times as
    // much, and the mip level follows. Taken once, not per map, and not fooled by the edges of faces.
    vec3 across = ACROSS(r, p.mirror_across), down = DOWN(r, p.mirror_down);
    float turns = max(dot(across, across), dot(down, down));
#ifdef SMOOTH_REFLECTIONS
    // Multisampling shades once a pixel: an edge of light seen in the coat would be a stair where an edge of the body
    // is smooth. So four places of the pixel are looked up, on a rotated grid, each with a third of the footprint.
    vec3 a = 0.375 * across + 0.125 * down, b = 0.375 * down - 0.125 * across;
    turns *= 0.125;
#define SHARP_LIGHT(k, level) 0.25 * (textureLod(sharp_maps[k], r + a, level).rgb \
        + textureLod(sharp_maps[k], r - a, level).rgb + textureLod(sharp_maps[k], r + b, level).rgb \
        + textureLod(sharp_maps[k], r - b, level).rgb)
#else
#define SHARP_LIGHT(k, level) textureLod(sharp_maps[k], r, level).rgb
#endif
    float turn = 0.5 * log2(max(max(turns, 4.0 * p.coat_spread * p.coat_spread), 1e-12));
#define ADD_SHARP_LOBE(k) \
    radiance += ramp_row(x, 1 + k).rgb * sharp_lobes[k].x \
        * (SHARP_LIGHT(k, turn + sharp_lobes[k].y)) ARRIVES(c, sharp_lobes[k].z);
    FOR_EACH_SHARP_LOBE(ADD_SHARP_LOBE)
    return light_colour * radiance;
}
