// Provides: the points of a lobe surface, with their place in its grid of rows and columns.
// Needs: points row by row, `columns` a row, as indexed elements.
#version 330 core

layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;

uniform mat4 to_clip;
uniform mat4 to_eye;
uniform int columns;

out vec3 eye_point;
out vec3 eye_normal;
out vec3 surface_colour;
out vec2 place;

void main() {
    gl_Position = to_clip * vec4(point, 1.0);
    eye_point = (to_eye * vec4(point, 1.0)).xyz;
    eye_normal = mat3(to_eye) * normal;
    surface_colour = colour;
    place = vec2(float(gl_VertexID / columns), float(gl_VertexID % columns));
}
