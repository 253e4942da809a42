// Provides: vec4 light_sample(int i), SAMPLE_COUNT; but for CAPTURED vec4 light_sample_at(ivec2 pixel, int i)
// Needs:    SAMPLES (0 or 1: a plain texture); with CAPTURED the shaded list of captured.glsl, and which of it is where
//
// One sample of the pixel that is being finished: exposed radiance, and whether the object is there.
#ifdef CAPTURED
const int SAMPLE_COUNT = SAMPLES;
uniform sampler2D light;         // the shaded list
uniform sampler2D sample_places; // which of the list each sample is, 0, 1 ...; below 0: none of the paint's
uniform sampler2D other_light;   // what is seen there instead, or over the paint, by its alpha; samples side by side
uniform ivec2 list_corner;       // of this paint's list in the texture
uniform ivec2 picture_corner;    // of this paint's picture in the target
uniform int list_width;

vec4 light_sample(int i)
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - picture_corner;
    int place = int(texelFetch(sample_places, pixel, 0)[i]);
    vec4 other = texelFetch(other_light, ivec2(pixel.x * SAMPLE_COUNT + i, pixel.y), 0);
    if (place < 0)
        return other;
    vec4 paint = texelFetch(light, list_corner + ivec2(place % list_width, place / list_width), 0);
    return vec4(other.rgb + (1.0 - other.a) * paint.rgb, paint.a);
}
#elif SAMPLES > 1
const int SAMPLE_COUNT = SAMPLES;
uniform sampler2DMS light;

vec4 light_sample_at(ivec2 pixel, int i)
{
    return texelFetch(light, pixel, i);
}
#else
const int SAMPLE_COUNT = 1;
uniform sampler2D light;

vec4 light_sample_at(ivec2 pixel, int i)
{
    return texelFetch(light, pixel, 0);
}
#endif
#ifndef CAPTURED
vec4 light_sample(int i)
{
    return light_sample_at(ivec2(gl_FragCoord.xy), i);
}
#endif
