// Provides: the shadow on the ground: what is left of the light there, to be multiplied onto the background
// Needs:    ground.vert.glsl; blending of destination times source; SUN where the environment has a sun
#ifdef SUN
#include "sun.glsl"

uniform vec3 sun_share;          // of the light on an open ground
#endif
uniform sampler2D ground_shadow; // what arrives of the light, but for the sun's where there is one, over that of all

in vec2 field;
in vec3 ground_position;
out vec4 fragment;

void main()
{
    vec3 arrives = texture(ground_shadow, field).rgb;
#ifdef SUN
    arrives += sun_share * sun_seen(ground_position, vec3(0.0, 1.0, 0.0));
#endif
    // The object's coverage in alpha is not the ground's matter.
    fragment = vec4(min(arrives, 1.0), 1.0);
}
