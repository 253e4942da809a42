// Provides: the colour difference between two pictures, pixel by pixel, in the colours of a scale
// Needs:    screen.vert.glsl; SCALE_STEPS; two pictures of the frame's size
#include "colour_difference.glsl"

uniform sampler2D first;
uniform sampler2D second;
uniform bool encoded;            // the pictures have the transfer curve of sRGB
uniform mat3 to_relative;        // their linear colours to tristimulus values over those of the white
uniform float gain;              // exposure, a factor
uniform float scale_end;         // the colour difference at the end of the scale
uniform vec3 scale_colours[SCALE_STEPS + 1];
out vec4 fragment;

vec3 linear(vec3 c)
{
    if (!encoded)
        return c * gain;
    vec3 curved = pow((max(c, 0.0) + 0.055) / 1.055, vec3(2.4));
    return mix(curved, c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}

float difference_at(ivec2 pixel)
{
    vec3 lab1 = lab_of_relative(to_relative * linear(texelFetch(first, pixel, 0).rgb));
    vec3 lab2 = lab_of_relative(to_relative * linear(texelFetch(second, pixel, 0).rgb));
    return delta_e_2000(lab1, lab2);
}

#ifdef AS_NUMBERS
void main()
{
    fragment = vec4(difference_at(ivec2(gl_FragCoord.xy)));
}
#else
void main()
{
    float at = clamp(difference_at(ivec2(gl_FragCoord.xy)) / scale_end, 0.0, 1.0) * float(SCALE_STEPS);
    int below = min(int(at), SCALE_STEPS - 1);
    fragment = vec4(mix(scale_colours[below], scale_colours[below + 1], at - float(below)), 1.0);
}
#endif
