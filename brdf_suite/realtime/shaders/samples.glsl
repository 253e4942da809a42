// Provides: vec4 light_sample(int i), SAMPLE_COUNT
// Needs:    SAMPLES (0 or 1: a plain texture)
//
// One sample of the pixel that is being finished: exposed radiance, and whether the object is there.
#if SAMPLES > 1
const int SAMPLE_COUNT = SAMPLES;
uniform sampler2DMS light;

vec4 light_sample(int i)
{
    return texelFetch(light, ivec2(gl_FragCoord.xy), i);
}
#else
const int SAMPLE_COUNT = 1;
uniform sampler2D light;

vec4 light_sample(int i)
{
    return texelFetch(light, ivec2(gl_FragCoord.xy), 0);
}
#endif
