// Provides: the mesh as a light sees it, in its tile of the shadow map
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;

uniform mat4 light_to_clip;

void main()
{
    gl_Position = light_to_clip * vec4(position, 1.0);
}
