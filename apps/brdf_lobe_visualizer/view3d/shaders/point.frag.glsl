// Provides: a disc with a rim, so that a point stands out from a surface of its own colour.
// Needs: point.vert.glsl
#version 330 core

in vec4 point_colour;

uniform float size;
uniform vec4 rim;
uniform float opacity;

out vec4 result;

void main() {
    float away = length(gl_PointCoord - 0.5) * (size + 2.0);
    float cover = clamp(0.5 * size + 0.5 - away, 0.0, 1.0);
    if (cover <= 0.0) discard;
    float inner = clamp(0.5 * size - 0.8 - away, 0.0, 1.0);
    vec4 colour = mix(rim, point_colour, inner);
    result = vec4(colour.rgb, colour.a * cover * opacity);
}
