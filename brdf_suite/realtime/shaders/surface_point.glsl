// Provides: struct SurfacePoint, SurfacePoint surface_point(vec3 eye)
// Needs:    world_position, world_normal, surface_uv of mesh.vert.glsl; a fragment shader (derivatives)
//
// Everything that shading asks of the place that a pixel shows. What a feature does not provide has the value of a
// plain surface: an open place, and a coat that lies flat on the base.
//
// With CAPTURED the places come from captured.glsl instead of a mesh: a form's fragments, drawn once and shaded with many
// paints. What derivatives they had is kept with them; ACROSS and DOWN take the one or the other. With BALL they are those of
// a ball (ball_point.glsl).
#include "facing.glsl"
#include "relief.glsl"

#ifdef CAPTURED
#define ACROSS(value, kept) (kept)
#define DOWN(value, kept) (kept)
#else
#define ACROSS(value, kept) dFdx(value)
#define DOWN(value, kept) dFdy(value)

#ifndef BALL
in vec3 world_position;
in vec3 world_normal;
in vec2 surface_uv;
#ifdef OCCLUSION
in vec4 arriving_light;
#ifdef TWO_SIDED
in vec4 arriving_behind;
#endif
#endif
#endif
#endif

struct SurfacePoint
{
    vec3 position;       // world, metres
    vec3 view;           // unit, to the eye
    vec3 normal;         // unit, on the side that is seen: of the base
    vec3 coat_normal;    // unit: of the coat, which is another than the base's where it has orange peel
    vec2 uv;             // millimetres on the surface
    vec3 bent;           // unit: the middle of the light that arrives; the normal at an open place
    float occlusion;     // share of a uniform light's irradiance that arrives, 0 to 1
    float base_spread;   // root mean square slope of relief too fine for this pixel, of the base
    float coat_spread;   // and of the coat
#ifdef CAPTURED
    vec3 normal_across, normal_down;    // from pixel to pixel: of the normal
    vec3 mirror_across, mirror_down;    // of the mirror direction, in the environment's axes
    vec2 place, place_across, place_down;    // of the flakes, mm (flake_place.glsl)
#endif
};

#if defined(CAPTURED)
#include "captured.glsl"
#elif defined(BALL)
#include "ball_point.glsl"
#else
SurfacePoint surface_point(vec3 eye)
{
    SurfacePoint p;
    p.position = world_position;
    p.view = normalize(eye - world_position);
    p.normal = facing_normal(world_normal, world_position, p.view);
    p.coat_normal = p.normal;
    p.uv = surface_uv;
    p.bent = p.normal;
    p.occlusion = 1.0;
#ifdef OCCLUSION
    // Baked for the side that the mesh's normal looks to; a back that was not baked is taken to see as much.
    vec4 baked = arriving_light;
#ifdef TWO_SIDED
    if (dot(world_normal, p.normal) < 0.0)
        baked = arriving_behind;
#endif
    vec3 arriving = baked.xyz;
    arriving -= min(2.0 * dot(arriving, p.normal), 0.0) * p.normal;
    p.bent = normalize(arriving + 1e-3 * p.normal);
    p.occlusion = clamp(baked.w, 0.0, 1.0);
#endif
    p.base_spread = 0.0;
    p.coat_spread = 0.0;
#if defined(NORMAL_MAP) || defined(COAT_RELIEF)
    mat2x3 axes = surface_axes(p.normal, world_position, surface_uv);
#endif
#ifdef NORMAL_MAP
    // The form itself: base and coat lean alike, and so does the middle of the light that arrives.
    vec3 shape = normal_map(surface_uv);
    vec3 leant = leaning(p.normal, shape.xy, axes, p.view);
    p.bent = normalize(p.bent + leant - p.normal);
    p.normal = leant;
    p.coat_normal = leant;
    p.base_spread = sqrt(shape.z);
    p.coat_spread = p.base_spread;
#endif
#ifdef COAT_RELIEF
    // The coat's own waviness: the base under it lies as it did.
    vec3 waves = orange_peel(surface_uv);
    p.coat_normal = leaning(p.normal, waves.xy, axes, p.view);
    p.coat_spread = sqrt(p.base_spread * p.base_spread + waves.z);
#endif
    return p;
}
#endif
