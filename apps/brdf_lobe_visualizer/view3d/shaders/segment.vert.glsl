// Provides: straight segments as wide on the screen as is asked, also tapering: grid lines, arrows and their heads.
// Needs: four corners an instance, drawn as a strip; core profiles draw no lines wider than one pixel.
#version 330 core

layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec2 widths; // at start and end, device pixels
layout(location = 3) in vec4 colour;

uniform mat4 to_clip;
uniform vec2 viewport; // device pixels

out vec4 segment_colour;
out float across;      // device pixels from the middle
out float half_width;

const float NEAR = 1e-4;

void main() {
    vec4 a = to_clip * vec4(start, 1.0);
    vec4 b = to_clip * vec4(end, 1.0);
    // What lies behind the eye is cut off, or it would come from the other side.
    if (a.w < NEAR) a = mix(a, b, clamp((NEAR - a.w) / (b.w - a.w), 0.0, 1.0));
    if (b.w < NEAR) b = mix(b, a, clamp((NEAR - b.w) / (a.w - b.w), 0.0, 1.0));
    vec2 pa = 0.5 * viewport * a.xy / a.w;
    vec2 pb = 0.5 * viewport * b.xy / b.w;
    vec2 along = pb - pa;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
    vec2 side = vec2(-along.y, along.x);
    float second = float(gl_VertexID / 2);
    float sign = float(gl_VertexID % 2) * 2.0 - 1.0;
    half_width = 0.5 * mix(widths.x, widths.y, second);
    across = sign * (half_width + 1.0);
    vec4 here = mix(a, b, second);
    here.xy += side * across * 2.0 / viewport * here.w;
    gl_Position = here;
    segment_colour = colour;
}
