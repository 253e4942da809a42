// Provides: the middles of discs of a size on the screen.
// Needs: locations 0 to 2 as pyqtgraph's GLScatterPlotItem feeds them; GL_PROGRAM_POINT_SIZE.
#version 330 core

layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
layout(location = 2) in float diameter; // logical pixels

uniform mat4 u_mvp;
uniform float ratio;   // device pixels a logical one
uniform vec4 viewport; // left, bottom, width, height, device pixels

out vec4 disc_colour;
out float size;
out vec2 middle; // device pixels

void main() {
    gl_Position = u_mvp * vec4(place, 1.0);
    // A little nearer: a point on a surface lies before it, whatever its triangles cut off.
    gl_Position.z -= 2e-3 * gl_Position.w;
    size = diameter * ratio;
    // Drivers place points on a grid of their own: a disc is drawn about its middle, in a point with room for it.
    middle = viewport.xy + 0.5 * viewport.zw * (1.0 + gl_Position.xy / gl_Position.w);
    gl_PointSize = size + 4.0;
    disc_colour = colour;
}
