// Provides: one slice of the lobe stack: a cube map of a lobe, resampled to the octahedral square
// Needs:    screen.vert.glsl; a target of the stack's size
#include "octahedral.glsl"

uniform samplerCube cube;
uniform float gain;              // the map's scale over the stack's
uniform float last_texel;        // texels of the square along an edge, less one
out vec4 fragment;

void main()
{
    vec2 place = (gl_FragCoord.xy - 0.5) / last_texel * 2.0 - 1.0;
    fragment = vec4(textureLod(cube, from_square(place), 0.0).rgb * gain, 1.0);
}
