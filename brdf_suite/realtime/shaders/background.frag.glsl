// Provides: the exposed light of what is seen past the surface: the environment, or a neutral grey
// Needs:    screen.vert.glsl
#include "environment.glsl"
#include "exposed.glsl"

uniform mat3 view_to_world;
uniform vec2 half_tangents;      // tangents of half the horizontal and vertical field of view
uniform vec4 frame;              // xy: this tile's corner in the whole picture, zw: 1 / size of the whole picture
uniform bool grey_background;

out vec4 fragment;

void main()
{
    vec2 ndc = (gl_FragCoord.xy + frame.xy) * frame.zw * 2.0 - 1.0;
    vec3 direction = view_to_world * vec3(ndc * half_tangents, -1.0);
    // The grey is a backdrop of 18 % at any exposure, so it does not change when the light is dimmed.
    vec3 radiance = grey_background ? vec3(0.18 / exposure) : background_radiance(direction);
    fragment = vec4(exposed_light(radiance), 0.0);
}
