// Provides: the exposed light of a surface with lobe weights, in the light of the prefiltered maps
// Needs:    what mesh.vert.glsl hands on; what lobes.glsl needs; LAMPS, SPARKLE_* and SECOND_PAINT where they are drawn;
//           LEFT_OUT where it hides what is behind it and is not to be seen itself; SEE_THROUGH where the surface is a pane;
//           DARK where the environment sends no light; KEPT_LIGHT where the look-ups have been made already, KEEPING where they are made to be kept
uniform vec3 eye;

#include "surface_point.glsl"
// A file is included once, so what both ways to the light share comes before the question which it is.
#include "ramp.glsl"
#include "environment.glsl"
#include "lobe_stack.glsl"
#ifdef KEPT_LIGHT
#include "kept_light.glsl"
#elif !defined(DARK)
#include "lobes.glsl"
#endif
#ifdef DARK
#define ENVIRONMENT_LIGHT(p) vec3(0.0)
#else
#define ENVIRONMENT_LIGHT(p) reflected_radiance(p)
#endif
#if defined(LAMPS) || defined(SUN) || defined(SPARKLE_GLINTS) || defined(SPARKLE_TEXTURE)
#include "lit.glsl"
#define LIT(p, radiance) lit_radiance(p, radiance)
#else
#define LIT(p, radiance) (radiance)
#endif
#include "exposed.glsl"
#ifdef SECOND_PAINT
#include "mask.glsl"
#endif
#ifdef SEE_THROUGH
#include "material.glsl"
uniform float transmittance;     // share of what is not mirrored
#endif

out vec4 fragment;

void main()
{
#ifdef LEFT_OUT
    fragment = vec4(0.0);
    return;
#endif
    SurfacePoint p = surface_point(eye);
    fragment = vec4(exposed_light(LIT(p, ENVIRONMENT_LIGHT(p))), 1.0);
#ifdef KEEPING
    fragment.a = ramp_coordinate(seen_cosine(p));
#endif
#ifdef SECOND_PAINT
    fragment.a = mask_share(p);    // how much of the first paint this is blended over
#endif
#ifdef SEE_THROUGH
    vec3 base_gain, gloss_gain;
    fresnel_gains(max(dot(p.normal, p.view), 0.0), base_gain, gloss_gain);
    float mirrored = min(gloss_albedo.g * gloss_gain.g, 1.0);
    fragment.a = 1.0 - transmittance * (1.0 - mirrored);    // what it hides of all that is behind it
#endif
}
