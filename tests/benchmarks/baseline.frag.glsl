// Provides: the yardstick of frame times: one reflection look-up and one diffuse look-up
// Needs:    world_position, world_normal of mesh.vert.glsl; SHARP
#include "environment.glsl"
#include "exposed.glsl"

uniform vec3 eye;
uniform samplerCube sharp_maps[SHARP];
uniform vec3 sharp_lobes[SHARP];

in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;

void main()
{
    vec3 v = normalize(eye - world_position);
    vec3 n = normalize(world_normal);
    vec3 r = to_environment(reflect(-v, n));
    vec3 radiance = 0.3 * texture(diffuse_map, to_environment(n)).rgb * diffuse_scale
        + 0.05 * texture(sharp_maps[0], r).rgb * sharp_lobes[0].x;
    fragment = vec4(exposed_light(radiance), 1.0);
}
