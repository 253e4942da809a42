// Provides: the exposed light of a picture that was traced, to be blended over the background by its alpha
// Needs:    screen.vert.glsl
//
// The picture holds the object's radiance, already weighted by its share of each pixel, and in alpha that share.
#include "exposed.glsl"

uniform sampler2D traced;
out vec4 fragment;

void main()
{
    vec4 light = texelFetch(traced, ivec2(gl_FragCoord.xy), 0);
    fragment = vec4(exposed_light(light.rgb), light.a);
}
