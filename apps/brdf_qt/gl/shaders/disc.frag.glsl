// Provides: a disc with a smooth edge and a rim, so that it stands out from a surface of its own colour.
// Needs: disc.vert.glsl; a rim with alpha 0 is none.
#version 330 core

in vec4 disc_colour;
in float size;

uniform vec4 rim;
uniform float opacity;

out vec4 result;

void main() {
    float away = length(gl_PointCoord - 0.5) * (size + 2.0);
    float cover = clamp(0.5 * size + 0.5 - away, 0.0, 1.0);
    if (cover <= 0.0) discard;
    float inner = mix(1.0, clamp(0.5 * size - 0.8 - away, 0.0, 1.0), rim.a);
    vec4 colour = mix(vec4(rim.rgb, 1.0), disc_colour, inner);
    result = vec4(colour.rgb, colour.a * cover * opacity);
}
