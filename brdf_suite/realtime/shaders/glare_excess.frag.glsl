// Provides: the mean light above white of a block of pixels, all samples of each
// Needs:    screen.vert.glsl; SAMPLES
#include "samples.glsl"

uniform ivec4 region;            // of the light: left, lower edge, right, upper edge; nothing else is read
uniform float white;
out vec4 fragment;

const int BLOCK = 2;             // pixels along an edge, as in glare.py

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * BLOCK;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < BLOCK * BLOCK; ++k)
    {
        ivec2 pixel = first + ivec2(k % BLOCK, k / BLOCK);
        if (any(lessThan(pixel, region.xy)) || any(greaterThanEqual(pixel, region.zw)))
            continue;
        for (int i = 0; i < SAMPLE_COUNT; ++i)
            sum += max(light_sample_at(pixel, i).rgb - white, 0.0);
    }
    fragment = vec4(sum / float(SAMPLE_COUNT * BLOCK * BLOCK), 0.0);
}
