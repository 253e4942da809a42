// Provides: the mesh as the sun sees it, in a box about it
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;

uniform vec3 sun_direction;
uniform vec4 sun_box;
uniform vec3 sun_right, sun_up;

void main()
{
    vec3 from_middle = (position - sun_box.xyz) / sun_box.w;
    gl_Position = vec4(dot(from_middle, sun_right), dot(from_middle, sun_up), -dot(from_middle, sun_direction), 1.0);
}
