// Provides: a fragment for each pixel of the object that the device cannot show, for an occlusion query
// Needs:    screen.vert.glsl; SAMPLES
#include "samples.glsl"
#include "display.glsl"

uniform int counted;             // 0: all of the object, 1: too bright, 2: too colourful
out vec4 fragment;

void main()
{
    vec4 light = light_sample(0);
    vec2 beyond = beyond_device(device_light(light.rgb));
    bool counts = counted == 0 || (counted == 1 ? beyond.x : beyond.y) > 0.0;
    if (light.a < 0.5 || !counts)
        discard;
    fragment = vec4(1.0);
}
