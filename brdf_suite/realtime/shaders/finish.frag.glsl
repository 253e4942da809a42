// Provides: the finished picture: samples averaged in linear light, sRGB transfer curve, dither, 8 bits
// Needs:    screen.vert.glsl; SAMPLES (0 or 1: a plain texture)
#include "transfer.glsl"

#if SAMPLES > 1
uniform sampler2DMS light;
#else
uniform sampler2D light;
#endif
uniform vec4 frame;              // xy: this tile's corner in the whole picture
out vec4 fragment;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#if SAMPLES > 1
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SAMPLES; ++i)
        sum += texelFetch(light, pixel, i).rgb;
    vec3 mean = sum / float(SAMPLES);
#else
    vec3 mean = texelFetch(light, pixel, 0).rgb;
#endif
    fragment = vec4(quantize(srgb_encode(mean), gl_FragCoord.xy + frame.xy), 1.0);
}
