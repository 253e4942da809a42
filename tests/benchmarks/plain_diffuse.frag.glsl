// Provides: the yardstick of a lamp's cost: a matt grey in one light
// Needs:    world_position, world_normal of mesh.vert.glsl; lights.glsl
#include "lights.glsl"
#include "exposed.glsl"

uniform vec3 eye;

in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;

void main()
{
    vec3 n = normalize(world_normal);
    vec3 sum = vec3(0.0);
    for (int i = int(light_counts.x); i < int(light_counts.y); ++i)
    {
        Arriving light = light_at(i, world_position);
        sum += light.irradiance * max(dot(n, light.direction), 0.0);
    }
    fragment = vec4(exposed_light(0.06 * sum), 1.0);
}
