// Provides: the mean of a pixel's samples times a weight, to be added up over exposures
// Needs:    screen.vert.glsl; samples.glsl; blending of one plus one
#include "samples.glsl"

uniform float weight;
out vec4 fragment;

void main()
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLE_COUNT; ++i)
        sum += light_sample(i);
    fragment = sum * (weight / float(SAMPLE_COUNT));
}
