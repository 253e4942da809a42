// Provides: world_position and world_normal for mesh.frag.glsl
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 world_to_clip;

out vec3 world_position;
out vec3 world_normal;

void main()
{
    world_position = position;
    world_normal = normal;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
