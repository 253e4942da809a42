// Provides: the colour of a segment with soft edges.
// Needs: segment.geom.glsl
#version 330 core

in vec4 segment_colour;
in float across;
in float half_width;

out vec4 result;

void main() {
    float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
    if (cover * segment_colour.a < 0.01) discard;
    result = vec4(segment_colour.rgb, segment_colour.a * cover);
}
