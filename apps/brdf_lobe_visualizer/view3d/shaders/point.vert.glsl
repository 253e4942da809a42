// Provides: round points of one size on the screen.
// Needs: point sizes set by the program (GL_PROGRAM_POINT_SIZE).
#version 330 core

layout(location = 0) in vec3 point;
layout(location = 1) in vec4 colour;

uniform mat4 to_clip;
uniform float size; // device pixels

out vec4 point_colour;

void main() {
    gl_Position = to_clip * vec4(point, 1.0);
    // A little nearer: a point on a surface lies before it, whatever its triangles cut off.
    gl_Position.z -= 2e-3 * gl_Position.w;
    gl_PointSize = size + 2.0;
    point_colour = colour;
}
