// Provides: the exposed light of what is seen past the surface: the environment, sharp or blurred, or a plain colour
// Needs:    screen.vert.glsl
#include "environment.glsl"
#include "lobe_stack.glsl"
#include "exposed.glsl"

uniform mat3 view_to_world;
uniform vec2 half_tangents;      // tangents of half the horizontal and vertical field of view
uniform vec2 lens_shift;         // tangents by which the middle of the picture lies aside of the axis
uniform vec4 frame;              // xy: this tile's corner in the whole picture, zw: 1 / size of the whole picture
uniform int backdrop;            // BACKDROP_*
uniform vec3 backdrop_colour;    // working space, after the exposure
uniform float backdrop_level;    // of the stack, of the lobe that blurs

const int BACKDROP_SHARP = 0, BACKDROP_BLURRED = 1, BACKDROP_PLAIN = 2;

out vec4 fragment;

void main()
{
    vec2 ndc = (gl_FragCoord.xy + frame.xy) * frame.zw * 2.0 - 1.0;
    vec3 direction = view_to_world * vec3(ndc * half_tangents + lens_shift, -1.0);
    // A plain backdrop looks the same at any exposure, so it does not change when the light is dimmed.
    vec3 radiance = backdrop_colour / exposure;
    if (backdrop == BACKDROP_BLURRED)
        radiance = light_colour * broad_light(to_environment(direction), backdrop_level);
    else if (backdrop == BACKDROP_SHARP)
        radiance = background_radiance(direction);
    fragment = vec4(exposed_light(radiance), 0.0);
}
