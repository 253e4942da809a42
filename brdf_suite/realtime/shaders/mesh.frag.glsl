// Provides: the display light of a surface with lobe weights, in the light of the prefiltered maps
// Needs:    world_position, world_normal of mesh.vert.glsl; LOBES, FOR_EACH_LOBE
uniform vec3 eye;

#include "facing.glsl"
#include "lobes.glsl"
#include "display.glsl"

in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;

void main()
{
    vec3 v = normalize(eye - world_position);
    vec3 n = facing_normal(world_normal, world_position, v);
    fragment = vec4(display_light(reflected_radiance(n, v)), 1.0);
}
