// Provides: vec3 lit_radiance(SurfacePoint p, vec3 radiance)
// Needs:    surface_point.glsl, material.glsl; LAMPS where there are lamps, SUN where the environment has a sun whose
//           shadow is cast (OCCLUSION then too), LAMP_SHADOWS where lamps cast theirs, SPARKLE_GLINTS or SPARKLE_TEXTURE where
//           flakes are drawn one by one; FACTORS where a factored material's lamps are shaded by its maps
//           (factors.glsl), FACTOR_BALL where by a ball (lamp_ball.glsl)
//
// `radiance`, what the surface reflects of the environment, with what single lights add. For a light of irradiance E on
// what faces it, from a direction whose mirror direction is gamma away from the eye, the lobe sum is
//     lamps         E (KD N.L + N.L sum KDD_i cos(gamma)^E_i + sum KG_i cos(gamma)^E_i)
//     all lights    E N.L f(gamma) (ratio - 1)
// with f the share of the base that visible flakes reflect, and ratio how bright those of this pixel are over their
// mean. The mean of ratio is 1, so flakes move light about and add none; the environment's own light is in its maps
// already.
#include "lights.glsl"
#include "light_lobes.glsl"
#if defined(SUN) || defined(LAMP_SHADOWS)
#include "shadows.glsl"
#endif
#ifdef LAMP_SHADOWS
float seen_of_lamps[MOST_SHADOWS];    // at the place that is shaded
#define LAMP_SEEN(i) seen_of_lamps[i - int(light_counts.x)]
#else
#define LAMP_SEEN(i) 1.0
#endif
#include "flake_place.glsl"
#ifdef FACTORS
#include "tangent_frame.glsl"
#include "factors.glsl"
#endif
#ifdef FACTOR_BALL
#include "lamp_ball.glsl"
#endif
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
// Index n of the coat, waviness of a flake in radians; n^2 cos^2 below the coat at the light's angle of the lobes' fit;
// light that a flake mirrors, of its largest channel, over what falls on it.
uniform vec4 flake_optics;

// Tilts rarer than this, and flakes whose contrast in all that is seen is less than this, are left out; both fade to
// there, so flakes melt into the smooth light with distance.
const float RAREST = 0.02, FAINTEST = 0.004;

float largest(vec3 c)
{
    return max(c.r, max(c.g, c.b));
}

#if defined(SPARKLE_GLINTS) && !defined(DARK) && !defined(FACTORS)
#define GRAIN
#include "flake_grain.glsl"
#endif

#if defined(LAMPS) && !defined(FACTOR_BALL) && (!defined(FACTORS) || defined(FACTORS_COATED))
#define LOBES_LIT
// What turns from pixel to pixel: the coat's highlight may be smaller than one, and is the mean of four places in it.
struct Turns
{
    vec3 normal_across, normal_down, view_across, view_down;
};

// The coat's highlight of a light, without its irradiance. The mirror direction of a light turns by twice the turn of
// the coat's normal. `radius` is that of the light's disc, radians.
vec3 coat_highlight(SurfacePoint p, vec3 to_light, float radius, Turns turns)
{
    vec3 n = p.coat_normal;
    float cos_coat = dot(n, to_light);
    if (cos_coat <= 0.0)
        return vec3(0.0);
    vec3 off = 2.0 * cos_coat * n - to_light - p.view;
    vec3 across = 0.5 * (dot(turns.normal_across, to_light) * n + cos_coat * turns.normal_across)
        - 0.25 * turns.view_across;
    vec3 down = 0.5 * (dot(turns.normal_down, to_light) * n + cos_coat * turns.normal_down) - 0.25 * turns.view_down;
    DiscLobe disc = disc_lobe(radius);
    vec4 beyond = max(vec4(length(off + across + down), length(off + across - down), length(off - across + down),
                           length(off - across - down)) - disc.middle, 0.0) / disc.stretch;
    return 0.25 * disc.share * (light_lobe(LOBE_GLOSS, beyond.x).rgb + light_lobe(LOBE_GLOSS, beyond.y).rgb
        + light_lobe(LOBE_GLOSS, beyond.z).rgb + light_lobe(LOBE_GLOSS, beyond.w).rgb);
}

// What the lamps make the surface reflect, flakes in their mean; of a factored material the coat's part alone.
vec3 lamp_radiance(SurfacePoint p, vec3 base_gain, vec3 gloss_gain)
{
    Turns turns = Turns(dFdx(p.coat_normal), dFdy(p.coat_normal), dFdx(p.view), dFdy(p.view));
    vec3 kd = light_diffuse();
    vec3 sum = vec3(0.0);
    for (int i = int(light_counts.x); i < int(light_counts.y); ++i)
    {
        Arriving light = light_at(i, p.position);
        light.irradiance *= LAMP_SEEN(i);
#ifndef FACTORS
        float cos_light = dot(p.normal, light.direction);
        if (cos_light > 0.0)
        {
            float chord = length(2.0 * cos_light * p.normal - light.direction - p.view);
            sum += light.irradiance * base_gain * cos_light * (kd + light_lobe(LOBE_BASE, chord).rgb);
        }
#endif
        sum += light.irradiance * gloss_gain * coat_highlight(p, light.direction, 2.0 * light.spread, turns);
    }
    return sum;
}
#endif

#ifdef SUN
float seen_of_sun;              // at the place that is shaded
// What the sun gives where it is seen, less what the maps have given of it: the share that occlusion left. Of the coat's
// reflection nothing is taken; there occlusion by the mirror direction stands.
vec3 sun_difference(SurfacePoint p, vec3 base_gain)
{
    float cos_sun = max(dot(p.normal, sun_direction), 0.0);
    float chord = length(2.0 * cos_sun * p.normal - sun_direction - p.view);
    vec3 kd = light_diffuse();
    vec3 lobes = cos_sun > 0.0 ? cos_sun * light_lobe(LOBE_BASE, chord).rgb : vec3(0.0);
    seen_of_sun = cos_sun > 0.0 ? light_seen(SUN_SHADOW, p.position, p.normal, cos_sun > 0.0) : 0.0;
    vec3 wanted = seen_of_sun * (cos_sun * kd + lobes);
    vec3 given = p.occlusion * (max(dot(p.bent, sun_direction), 0.0) * kd + lobes);
    return sun_irradiance * base_gain * (wanted - given);
}
#endif

#ifdef SPARKLE
// What flakes reflect goes with one over the cosines below the coat; their lobe has those of the fit.
float crossing(vec3 to_light, vec3 to_eye)
{
    float n2 = flake_optics.x * flake_optics.x;
    float below = (n2 - dot(to_light.xy, to_light.xy)) * (n2 - dot(to_eye.xy, to_eye.xy));
    return flake_optics.z * inversesqrt(max(below, 1e-2));
}

// What single flakes add to their mean, and take from it; `radiance` is all that is seen beside.
vec3 sparkle(SurfacePoint p, FlakePlace place, vec3 base_gain, vec3 radiance)
{
    float faintest = FAINTEST * largest(radiance);
    mat3 to_local = local_frame(p.normal);
    vec3 to_eye = to_local * p.view;
    vec3 sum = vec3(0.0);
#ifdef SPARKLE_GLINTS
    int glinting = 0;
    GlintField field = glint_field(place.at, place.across, place.down, flakes.x, flakes.y, flakes.z, flake_optics.y,
                                   flakes.w);
#else
    FlakeTexture field = flake_texture(place.at, place.across, place.down, flakes.x, flakes.y, flakes.z, flakes.w);
    if (field.contrast <= 0.0)
        return sum;
#endif
    // No light stands out by more than flakes that lie flat do in a light without extent: the visible ones become
    // rarer with their tilt by more than their contrast rises. So faint and broad lights are skipped at once.
    float most = largest(base_gain * flake_lobe(0.0));
#ifdef SPARKLE_GLINTS
    most *= glint_contrast(field, 0.5 / flakes.z * flake_optics.y);
#else
    most *= flake_contrast(field, flake_optics.y);
#endif
    // Mostly none does, from afar: a software renderer, which carries a loop's body out for lights that are passed
    // over, is then spared it.
    int reaching = 0;
    for (int i = 0; i < int(light_counts.y); ++i)
    {
        if (largest(light_at(i, p.position).irradiance) * most > faintest)
            reaching = i + 1;
    }
    for (int i = 0; i < reaching; ++i)
    {
        Arriving light = light_at(i, p.position);
        if (largest(light.irradiance) * most <= faintest)
            continue;
        float cos_light = dot(p.normal, light.direction);
        if (cos_light <= 0.0)
            continue;
        vec3 to_light = to_local * light.direction;
        vec2 slope = flake_slope(to_light, to_eye, flake_optics.x);
        float bell = tilt_bell(dot(slope, slope), flakes.z);
        if (bell <= RAREST)
            continue;
        float chord = length(2.0 * cos_light * p.normal - light.direction - p.view);
        vec3 flake_light = light.irradiance * base_gain * (cos_light * bell * crossing(to_light, to_eye)) * flake_lobe(chord);
        if (float(i) < light_counts.x)
        {
#ifdef SUN
            flake_light *= dot(light.direction, sun_direction) > 0.999999 ? seen_of_sun : p.occlusion;
#else
            flake_light *= p.occlusion;
#endif
        }
        else
            flake_light *= LAMP_SEEN(i);
        // A light's extent, seen by a mirror below the coat, is a spread of the mirror's tilt of 1 / (2 n) of it.
        float broad = light.spread / (2.0 * flake_optics.x);
        float spread = sqrt(flake_optics.y * flake_optics.y + broad * broad);
#ifdef SPARKLE_GLINTS
        vec3 tilt = tilt_place(slope, flakes.z);
        float contrast = glint_contrast(field, tilt.z * spread);
#else
        float contrast = flake_contrast(field, spread);
#endif
        float seen = smoothstep(RAREST, 2.0 * RAREST, bell)
            * smoothstep(faintest, 3.0 * faintest, largest(flake_light) * contrast);
        if (seen <= 0.0)
            continue;
#ifdef SPARKLE_GLINTS
        glint_places[glinting] = tilt.xy;
        glint_widths[glinting] = tilt.z * spread;
        glint_powers[glinting] = flake_light * seen;
        ++glinting;
#else
        sum += flake_light * seen * (flake_texture_ratio(field, slope, spread) - 1.0);
#endif
    }
#ifdef SPARKLE_GLINTS
    if (glinting > 0)
        sum = glint_difference(field, glinting);
#endif
    return sum;
}
#endif

#ifdef LAMP_SHADOWS
// What the place sees of each lamp; returned is the same of all lamps together, by what they send to the base.
float look_for_lamps(SurfacePoint p)
{
    float arriving = 0.0, arrived = 0.0;
    for (int i = int(light_counts.x); i < int(light_counts.y); ++i)
    {
        Arriving light = light_at(i, p.position);
        float cos_light = dot(p.normal, light.direction);
        int lamp = i - int(light_counts.x);
        float seen = light_seen(FIRST_LAMP_SHADOW + lamp, p.position, p.normal, cos_light > 0.0);
        float sent = largest(light.irradiance) * max(cos_light, 0.0);
        seen_of_lamps[lamp] = seen;
        arriving += sent;
        arrived += seen * sent;
    }
    return arriving > 0.0 ? arrived / arriving : 1.0;
}
#endif

vec3 lit_radiance(SurfacePoint p, vec3 radiance)
{
#ifdef LAMP_SHADOWS
    float of_lamps = look_for_lamps(p);
#else
    const float of_lamps = 1.0;
#endif
    vec3 base_gain, gloss_gain;
    fresnel_gains(max(dot(p.normal, p.view), 0.02), base_gain, gloss_gain);
#ifdef FACTORS
    radiance += factored_radiance(p);
#endif
#ifdef FACTOR_BALL
    radiance += of_lamps * ball_radiance(p);
#endif
#ifdef LOBES_LIT
    radiance += lamp_radiance(p, base_gain, gloss_gain);
#endif
#ifdef SUN
    radiance = max(radiance + sun_difference(p, base_gain), 0.0);
#endif
#ifdef SPARKLE
    // Derivatives are taken before anything is asked that neighbours may answer otherwise.
    FlakePlace place = flake_place(p);
    if (flakes.x > 0.0)
    {
        vec3 difference = sparkle(p, place, base_gain, radiance);
#ifdef GRAIN
        difference += grain_difference(p, place, base_gain, radiance);
#endif
        radiance = max(radiance + difference, 0.0);
    }
#endif
    return radiance;
}
