// Provides: uniform float exposure; vec3 exposed_light(vec3 radiance)
// Needs:    nothing
//
// What is drawn into the light target: radiance of the working space (linear Rec. 2020, D65) times the exposure, in
// half floats. The alpha beside it is 1 where the object is and 0 where the background is. Tone curve, primaries and
// transfer curve follow for each sample in finish.frag.glsl.
uniform float exposure;          // factor, 2^EV

vec3 exposed_light(vec3 radiance)
{
    return min(radiance * exposure, vec3(6e4));      // the largest half float is 65,504; beyond is infinite
}
