// Provides: the ends of straight segments, with their widths.
// Needs: locations 0 and 1 as pyqtgraph's GLLinePlotItem feeds them; segment.geom.glsl.
#version 330 core

layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
layout(location = 2) in float width; // logical pixels

uniform mat4 u_mvp;
uniform float ratio; // device pixels a logical one

out vec4 end_colour;
out float end_width;

void main() {
    gl_Position = u_mvp * vec4(place, 1.0);
    end_colour = colour;
    end_width = width * ratio;
}
