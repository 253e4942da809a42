// Provides: the middles of discs of a size on the screen.
// Needs: locations 0 to 2 as pyqtgraph's GLScatterPlotItem feeds them; GL_PROGRAM_POINT_SIZE.
#version 330 core

layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
layout(location = 2) in float diameter; // logical pixels

uniform mat4 u_mvp;
uniform float ratio; // device pixels a logical one

out vec4 disc_colour;
out float size;

void main() {
    gl_Position = u_mvp * vec4(place, 1.0);
    // A little nearer: a point on a surface lies before it, whatever its triangles cut off.
    gl_Position.z -= 2e-3 * gl_Position.w;
    size = diameter * ratio;
    gl_PointSize = size + 2.0;
    disc_colour = colour;
}
