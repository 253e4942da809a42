// Provides: vec3 factored_radiance(SurfacePoint p): what the lamps make a factored material reflect
// Needs:    surface_point.glsl, lights.glsl, material.glsl, tangent_frame.glsl; FACTORS_COATED below a clearcoat;
// FACTOR_TERMS, FACTOR_FLAT, FACTOR_CUBES (numbers),           FACTORS_OF_VIEW, FACTORS_OF_LIGHT (written by
// factors/textures.py), FACTOR_FRAME where maps are over directions
//
// McCool, Ang and Ahmad 2001, equation 20, for all lamps in one pass:
//     Lo = sum over lamps  E N.L f(wo, wi),      f = sum over terms  alpha prod of maps
// The maps hold logarithms: those of a term are added and exponentiated once, so that nothing is clamped on the way and
// dark values keep their relative accuracy (section 4.1). f then bends softly towards factor_ceiling, in brightness and
// not in colour. Factors of the view are looked up once; a lamp below the horizon adds nothing, but is looked up like
// any other, as the derivatives that choose a mip level are not defined behind a condition that neighbours answer
// otherwise.
#if FACTOR_FLAT > 0
uniform sampler2D factor_maps[FACTOR_FLAT];
uniform vec3 factor_spans[FACTOR_FLAT];      // what a texel is multiplied by, with FACTOR_SPANS
uniform float factor_levels[FACTOR_FLAT];    // log2(texels in a radian)
#endif
#if FACTOR_CUBES > 0
uniform samplerCube factor_cubes[FACTOR_CUBES];
uniform vec3 factor_cube_spans[FACTOR_CUBES];
uniform float factor_cube_levels[FACTOR_CUBES];
#endif
uniform vec3 factor_alphas[FACTOR_TERMS];    // logarithms of alpha
uniform float factor_limit;                  // largest logarithm of f that is exponentiated
uniform float factor_ceiling;                // 1 / ceiling, sr

// The place of a direction in a parabolic map, 0 to 1; from below the horizon it is brought there.
vec2 disc_place(vec3 w)
{
    return 0.5 + 0.5 * w.xy / (1.0 + max(w.z, 0.0));
}

// tan(theta / 2)
float disc_radius(float cosine)
{
    return sqrt(max(1.0 - cosine, 0.0) / (1.0 + cosine));
}

// A map's mip level: the logarithm of how far directions turn from pixel to pixel, and that of its texels in a radian.
// It is computed once a pixel, which is cheaper than by each look-up. A map over the root of a radius has texels that
// are finer towards the middle (FINE_FACTOR), as far as a pixel's own radius there.
#ifdef FACTOR_SPANS
#define SPAN(k) * factor_spans[k]
#define CUBE_SPAN(k) * factor_cube_spans[k]
#else
#define SPAN(k)
#define CUBE_SPAN(k)
#endif
#define FLAT_FACTOR(k, at) (textureLod(factor_maps[k], at, turn + factor_levels[k]).rgb SPAN(k))
#define FINE_FACTOR(k, at) (textureLod(factor_maps[k], at, turn + factor_levels[k] - log2(max(half_root, turn_root))).rgb SPAN(k))
#define CUBE_FACTOR(k, direction) (textureLod(factor_cubes[k], direction, turn + factor_cube_levels[k]).rgb CUBE_SPAN(k))

// The logarithm to base 2 of the radians by which normal and view turn from pixel to pixel; what of a relief is too
// fine for a pixel counts as well.
float pixel_turn(SurfacePoint p)
{
    vec3 normal_across = dFdx(p.normal), normal_down = dFdy(p.normal);
    vec3 view_across = dFdx(p.view), view_down = dFdy(p.view);
    float turns = max(dot(normal_across, normal_across) + dot(view_across, view_across),
                      dot(normal_down, normal_down) + dot(view_down, view_down));
    return 0.5 * log2(max(max(turns, p.base_spread * p.base_spread), 1e-12));
}

#ifdef FACTORS_COATED
uniform vec4 factor_coat;                    // index, spread of the base, K of matt light, mean F of even light
uniform vec3 factor_albedo;                  // of the base without the coat

// What the base is multiplied by below a clearcoat: T(light) T(view) / mean T  (1 - K) / (1 - K albedo), as
// reflectance/models/coated.py has it.
vec3 through_coat(float cos_light, float cos_view)
{
    float through = (1.0 - fresnel_dielectric(cos_light, factor_coat.x))
        * (1.0 - fresnel_dielectric(cos_view, factor_coat.x));
    float one_way = sqrt(max(through, 1e-12));
    float stays = mix(1.0 - one_way, factor_coat.z, factor_coat.y);
    float mean = mix(one_way, 1.0 - factor_coat.w, factor_coat.y);
    return through / mean * (1.0 - stays) / (1.0 - stays * factor_albedo);
}
#endif

vec3 factored_radiance(SurfacePoint p)
{
    float cos_view = clamp(dot(p.normal, p.view), 0.0, 1.0);
#ifdef FACTOR_FRAME
    mat3 to_local = tangent_frame(p);
    vec3 wo = to_local * p.view;
#endif
    float turn = pixel_turn(p);
    float turn_root = exp2(0.5 * turn - 0.5);    // root of a pixel's extent over a radius, about the middle
    FACTORS_OF_VIEW
    vec3 sum = vec3(0.0);
    for (int i = int(light_counts.x); i < int(light_counts.y); ++i)
    {
        Arriving light = light_at(i, p.position);
        float cos_light = clamp(dot(p.normal, light.direction), 0.0, 1.0);
        float cos_across = clamp(dot(light.direction, p.view), -1.0, 1.0);
        vec3 between = light.direction + p.view;
        // Never opposite: both are above the horizon, or nothing comes of it.
        vec3 facet = between * inversesqrt(max(dot(between, between), 1e-12));
        float cos_half = sqrt(0.5 * cos_across + 0.5);
        float cos_facet = clamp(dot(p.normal, facet), 0.0, 1.0);
        // By the sine, which near the normal is accurate where the cosine is not.
        float half_radius = length(facet - cos_facet * p.normal) / (1.0 + cos_facet);
        float half_root = sqrt(half_radius);
#ifdef FACTOR_FRAME
        vec3 wi = to_local * light.direction;
        vec3 h = to_local * facet;
#endif
        vec3 f = vec3(0.0);
        FACTORS_OF_LIGHT
#ifdef FACTORS_COATED
        f *= through_coat(cos_light, cos_view);
#endif
        float over = max(f.r, max(f.g, f.b)) * factor_ceiling;
        over *= over;
        sum += LAMP_SEEN(i) * light.irradiance * (cos_light * inversesqrt(sqrt(1.0 + over * over))) * f;
    }
    return sum;
}
