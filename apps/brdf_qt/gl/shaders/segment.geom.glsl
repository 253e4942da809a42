// Provides: segments as wide on the screen as is asked, also tapering: grid lines, arrows and their heads.
// Needs: segment.vert.glsl; core profiles draw no lines wider than one pixel.
#version 330 core

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

in vec4 end_colour[];
in float end_width[];

uniform vec2 viewport; // device pixels

out vec4 segment_colour;
out float across;      // device pixels from the middle
out float half_width;

const float NEAR = 1e-4;

void main() {
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    // What lies behind the eye is cut off, or it would come from the other side.
    if (a.w < NEAR && b.w < NEAR) return;
    if (a.w < NEAR) a = mix(a, b, (NEAR - a.w) / (b.w - a.w));
    if (b.w < NEAR) b = mix(b, a, (NEAR - b.w) / (a.w - b.w));
    vec2 along = 0.5 * viewport * (b.xy / b.w - a.xy / a.w);
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
    vec2 side = vec2(-along.y, along.x);
    for (int corner = 0; corner < 4; ++corner) {
        vec4 here = corner < 2 ? a : b;
        half_width = 0.5 * end_width[corner / 2];
        across = (float(corner % 2) * 2.0 - 1.0) * (half_width + 1.0);
        here.xy += side * across * 2.0 / viewport * here.w;
        gl_Position = here;
        segment_colour = end_colour[corner / 2];
        EmitVertex();
    }
    EndPrimitive();
}
