// Provides: the shadow on the ground: what is left of the light there, to be multiplied onto the background
// Needs:    ground.vert.glsl; blending of destination times source; SUN where the environment has a sun, LAMP_SHADOWS
//           where lamps light the ground
#if defined(SUN) || defined(LAMP_SHADOWS)
#include "shadows.glsl"
#endif
#ifdef SUN
uniform vec3 sun_share;          // of the environment's light on an open ground
#endif
#ifdef LAMP_SHADOWS
#include "lights.glsl"
uniform vec3 open_light;         // irradiance of an open ground by the environment
#endif
uniform sampler2D ground_shadow; // what arrives of the environment's light, but for a sun's, over that of all

in vec2 field;
in vec3 ground_position;
out vec4 fragment;

void main()
{
    const vec3 UP = vec3(0.0, 1.0, 0.0);
    vec3 arrives = texture(ground_shadow, field).rgb;
#ifdef SUN
    arrives += sun_share * light_seen(SUN_SHADOW, ground_position, UP, true);
#endif
#ifdef LAMP_SHADOWS
    vec3 lit = arrives * open_light, all = open_light;
    for (int i = int(light_counts.x); i < int(light_counts.y); ++i)
    {
        Arriving light = light_at(i, ground_position);
        vec3 level = light.irradiance * max(light.direction.y, 0.0);
        lit += level * light_seen(FIRST_LAMP_SHADOW + i - int(light_counts.x), ground_position, UP,
                                  light.direction.y > 0.0);
        all += level;
    }
    // Ground that no light reaches is as dark as it is.
    arrives = mix(arrives, lit / max(all, 1e-12), vec3(greaterThan(all, vec3(1e-9))));
#endif
    // The object's coverage in alpha is not the ground's matter.
    fragment = vec4(min(arrives, 1.0), 1.0);
}
