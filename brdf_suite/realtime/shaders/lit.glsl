// Provides: vec3 lit_radiance(SurfacePoint p, vec3 radiance)
// Needs:    surface_point.glsl, material.glsl; LAMPS where there are lamps, SPARKLE_GLINTS or SPARKLE_TEXTURE where
//           flakes are drawn one by one
//
// `radiance`, what the surface reflects of the environment, with what single lights add. For a light of irradiance E on
// what faces it, from a direction whose mirror direction is gamma away from the eye, the lobe sum is
//     lamps         E (KD N.L + N.L sum KDD_i cos(gamma)^E_i + sum KG_i cos(gamma)^E_i)
//     all lights    E N.L f(gamma) (ratio - 1)
// with f the share of the base that countable flakes send, and ratio how bright those of this pixel are over their mean.
// The mean of ratio is 1, so flakes move light about and add none; the environment's own light is in its maps already.
#include "lights.glsl"
#include "light_lobes.glsl"
#include "flake_place.glsl"
// A file is included once, so what both ways of sparkling share comes before the question which it is.
#include "sparkle_hash.glsl"
#include "flake_footprint.glsl"
#include "flake_tilt.glsl"
#include "flake_tint.glsl"
#ifdef SPARKLE_GLINTS
#include "sparkle_glints.glsl"
#define SPARKLE
#endif
#ifdef SPARKLE_TEXTURE
#include "flake_texture.glsl"
#define SPARKLE
#endif

uniform vec4 flakes;            // density 1/mm^2, size mm, roughness of the tilts, colour spread; density 0: none
uniform vec2 flake_optics;      // index of the coat, waviness of a flake in radians

// Tilts rarer than this, and flakes that stand out from the rest by less than this, are left out; both fade to there.
const float RAREST = 0.02, FAINTEST = 0.004;

float largest(vec3 c)
{
    return max(c.r, max(c.g, c.b));
}

vec3 lit_radiance(SurfacePoint p, vec3 radiance)
{
    vec3 base_gain, gloss_gain;
    float cos_view = dot(p.normal, p.view);
    fresnel_gains(max(cos_view, 0.02), base_gain, gloss_gain);
    FlakePlace place = flake_place(p);
    // The mirror direction of a light turns twice as far as the coat's normal from pixel to pixel.
    vec3 normal_across = dFdx(p.coat_normal), normal_down = dFdy(p.coat_normal);
    vec3 view_across = dFdx(p.view), view_down = dFdy(p.view);
    int first = int(light_counts.x), last = int(light_counts.y);

#ifdef SPARKLE
    bool sparkles = flakes.x > 0.0;
    mat3 to_local = local_frame(p.normal);
    vec3 to_eye = to_local * p.view;
    float faintest = FAINTEST * largest(radiance);
    if (sparkles)
        first = 0;
#ifdef SPARKLE_GLINTS
    GlintField field;
    int glinting = 0;
    if (sparkles)
        field = glint_field(place.at, place.across, place.down, flakes.x, flakes.y, flakes.z, flake_optics.y, flakes.w);
#else
    FlakeTexture field;
    if (sparkles)
        field = flake_texture(place.at, place.across, place.down, flakes.x, flakes.y, flakes.z, flakes.w);
    sparkles = sparkles && field.contrast > 0.0;
#endif
#endif

    vec3 sum = vec3(0.0);
    for (int i = first; i < last; ++i)
    {
        Arriving light = light_at(i, p.position);
        float cos_light = dot(p.normal, light.direction);
        if (cos_light <= 0.0)
            continue;
        bool lamp = i >= int(light_counts.x);
        float chord = length(2.0 * cos_light * p.normal - light.direction - p.view);
        vec3 base = light.irradiance * base_gain * cos_light;
#ifdef LAMPS
        if (lamp)
        {
            vec4 directional = light_lobe(LOBE_BASE, chord);
            vec3 kd = vec3(directional.a, light_lobe(LOBE_GLOSS, 1.0).a, light_lobe(LOBE_FLAKES, 1.0).a);
            sum += base * (kd + directional.rgb);
            // The coat's highlight may be smaller than a pixel: the mean of four places in it.
            float cos_coat = dot(p.coat_normal, light.direction);
            vec3 off = 2.0 * cos_coat * p.coat_normal - light.direction - p.view;
            vec3 turn_across = 0.25 * (2.0 * (dot(normal_across, light.direction) * p.coat_normal
                + cos_coat * normal_across) - view_across);
            vec3 turn_down = 0.25 * (2.0 * (dot(normal_down, light.direction) * p.coat_normal
                + cos_coat * normal_down) - view_down);
            vec3 gloss = light_lobe(LOBE_GLOSS, length(off + turn_across + turn_down)).rgb
                + light_lobe(LOBE_GLOSS, length(off + turn_across - turn_down)).rgb
                + light_lobe(LOBE_GLOSS, length(off - turn_across + turn_down)).rgb
                + light_lobe(LOBE_GLOSS, length(off - turn_across - turn_down)).rgb;
            if (cos_coat > 0.0)
                sum += light.irradiance * gloss_gain * (0.25 * gloss);
        }
#endif
#ifdef SPARKLE
        if (sparkles)
        {
            vec2 slope = flake_slope(to_local * light.direction, to_eye, flake_optics.x);
            float bell = tilt_bell(dot(slope, slope), flakes.z);
            if (bell <= RAREST)
                continue;
            vec3 countable = base * flake_lobe(chord);
            if (!lamp)
                countable *= p.occlusion;
            // A light's extent, seen by a mirror below the coat, is a spread of the mirror's tilt of 1 / (2 n) of it.
            float broad = light.spread / (2.0 * flake_optics.x);
            float spread = sqrt(flake_optics.y * flake_optics.y + broad * broad);
#ifdef SPARKLE_GLINTS
            vec3 tilt = tilt_place(slope, flakes.z);
            float height = glint_height(field, tilt.z * spread);
#else
            float height = flake_height(field, spread);
#endif
            float seen = smoothstep(RAREST, 2.0 * RAREST, bell)
                * smoothstep(faintest, 3.0 * faintest, largest(countable) * height);
            if (seen <= 0.0)
                continue;
#ifdef SPARKLE_GLINTS
            glint_places[glinting] = tilt.xy;
            glint_widths[glinting] = tilt.z * spread;
            glint_powers[glinting] = countable * seen;
            ++glinting;
#else
            sum += countable * seen * (flake_texture_ratio(field, slope, spread) - 1.0);
#endif
        }
#endif
    }
#ifdef SPARKLE_GLINTS
    if (glinting > 0)
        sum += glint_difference(field, glinting);
#endif
    return max(radiance + sum, 0.0);
}
