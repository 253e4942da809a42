// Provides: vec3 display_light(vec3 radiance)
// Needs:    nothing
//
// Radiance in the working space (linear Rec. 2020, D65) -> exposure -> tone curve -> sRGB primaries -> clipped.
// The transfer curve follows after the samples of a pixel have been averaged, in finish.frag.glsl.
#include "tone_curve.glsl"

uniform float exposure;          // factor, 2^EV
uniform int tone_curve_kind;
uniform mat3 working_to_display;

vec3 display_light(vec3 radiance)
{
    return clamp(working_to_display * tone_curve(radiance * exposure, tone_curve_kind), 0.0, 1.0);
}
