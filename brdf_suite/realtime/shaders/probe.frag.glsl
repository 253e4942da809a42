// Provides: where a pixel looks at the surface, its normal there, and which part of the mesh it is
// Needs:    mesh.vert.glsl
#include "facing.glsl"

uniform vec3 eye;
uniform int part;
uniform bool as_normal;          // the normal and 1, instead of the position and the part counted from 1

in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;

void main()
{
    vec3 n = facing_normal(world_normal, world_position, normalize(eye - world_position));
    fragment = as_normal ? vec4(n, 1.0) : vec4(world_position, float(part + 1));
}
