// Provides: vec3 device_light(vec3 exposed), vec2 beyond_device(vec3 device), vec3 marked(vec3 encoded, vec2 beyond, vec2 pixel)
// Needs:    nothing
//
// Exposed radiance of the working space -> tone curve -> linear light of the screen's three channels, not clipped.
#include "tone_curve.glsl"

uniform int tone_curve_kind;
uniform mat3 working_to_display;
uniform vec2 marks;              // x: mark what is too bright, y: what is too colourful; 0 or 1
uniform bool mark_in_colour;

// Half a code of 8 bits, at white and at black: less is not lost.
const float BRIGHTER = 1.0045;
const float MORE_COLOURFUL = -1.5e-4;

vec3 device_light(vec3 exposed)
{
    return working_to_display * tone_curve(exposed, tone_curve_kind);
}

// x: a channel above white is cut off; y: a channel below 0, so the colour lies outside of the screen's gamut.
vec2 beyond_device(vec3 device)
{
    return vec2(max(device.r, max(device.g, device.b)) > BRIGHTER,
                min(device.r, min(device.g, device.b)) < MORE_COLOURFUL);
}

// Zebra stripes, black rising and grey falling, or one colour for each; what is both shows the gamut's mark.
vec3 marked(vec3 encoded, vec2 beyond, vec2 pixel)
{
    vec2 wanted = beyond * marks;
    if (wanted.y > 0.0)
    {
        if (mark_in_colour)
            return vec3(0.0, 0.447, 0.698);
        return mod(floor(pixel.x) + floor(pixel.y), 8.0) < 4.0 ? vec3(0.5) : encoded;
    }
    if (wanted.x > 0.0)
    {
        if (mark_in_colour)
            return vec3(0.835, 0.369, 0.0);
        return mod(floor(pixel.x) - floor(pixel.y), 8.0) < 4.0 ? vec3(0.0) : encoded;
    }
    return encoded;
}
