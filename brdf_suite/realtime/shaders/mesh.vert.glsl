// Provides: world_position, world_normal and surface_uv (millimetres) for mesh.frag.glsl
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

uniform mat4 world_to_clip;

out vec3 world_position;
out vec3 world_normal;
out vec2 surface_uv;

void main()
{
    world_position = position;
    world_normal = normal;
    surface_uv = uv;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
