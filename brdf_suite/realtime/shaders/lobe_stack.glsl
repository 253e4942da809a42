// Provides: vec3 broad_light(vec3 direction, float level): the light about a direction, through a broad cosine lobe;
//           float widened(float level, float exponent, float spread)
// Needs:    nothing
//
// All broad lobe maps in one texture: octahedral squares, one above the other by rising exponent (textures.py).
// level is the third coordinate; between two slices the hardware mixes linearly, so that exponents are continuous.
// direction: of the environment's own axes (to_environment), of any length.
#include "octahedral.glsl"

uniform sampler3D lobe_stack;
uniform float stack_scale;
uniform vec2 stack_square;       // place in [-1, 1] times x plus y: texture coordinate
uniform float stack_octave;      // how much of the third coordinate doubles an exponent, on average

// By how many octaves slopes of root mean square "spread" lower a lobe's exponent E. They turn R by twice as much, and
// the lobe, of a variance of 1 / E to either side, is given 4 spread^2 more.
float octaves_lost(float exponent, float spread)
{
    return log2(1.0 + 4.0 * spread * spread * exponent);
}

float widened(float level, float exponent, float spread)
{
    return level - stack_octave * octaves_lost(exponent, spread);
}

vec3 broad_light(vec3 direction, float level)
{
    vec2 place = to_square(direction) * stack_square.x + stack_square.y;
    return texture(lobe_stack, vec3(place, level)).rgb * stack_scale;
}
