// Provides: panes as a light sees them, in its tile
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;

uniform mat4 light_to_clip;

out vec3 place;

void main()
{
    place = position;
    gl_Position = light_to_clip * vec4(position, 1.0);
}
