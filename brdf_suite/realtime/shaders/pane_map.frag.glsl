// Provides: the share of a light that a pane passes, and how near it is to the light, 0 to 1
// Needs:    pane_map.vert.glsl; blending that multiplies colours and keeps the least alpha
#include "fresnel.glsl"
uniform vec4 light_from;         // unit, to a distant light, or place of a near one, metres; w: 1 for a near light
uniform float ior;
uniform float transmittance;     // share of what is not mirrored

in vec3 place;
out vec4 fragment;

void main()
{
    vec3 way = light_from.w > 0.5 ? light_from.xyz - place : light_from.xyz;
    float f = fresnel_dielectric(abs(dot(normalize(cross(dFdx(place), dFdy(place))), normalize(way))), ior);
    fragment = vec4(vec3(transmittance * (1.0 - 2.0 * f / (1.0 + f))), gl_FragCoord.z);
}
