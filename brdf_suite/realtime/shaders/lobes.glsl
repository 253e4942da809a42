// Provides: vec3 reflected_radiance(SurfacePoint p), equations 7 to 9 of the paper
// Needs:    surface_point.glsl; LOBES, FOR_EACH_LOBE(BODY) = BODY(0) BODY(1) ... (both written by shader_source.py)
//
// With P_i the unit-gain map of lobe i, R the mirror direction of the view about N:
//     Lo =  pi KD P_1(N)                                   equation 9: the diffuse map looked up at N
//         + sum KDD_i 2 pi/(E_i+1) P_i(R) (N.R)            equation 7: the light direction is taken as R
//         + sum KG_i  2 pi/(E_i+1) P_i(R)                  equation 8
// One look-up serves equations 7 and 8; lobes without a weight are not looked up at all, so the maps are bound
// material by material and there is a program for a few numbers of look-ups. OpenGL 3.3 allows arrays of samplers
// to be indexed by constants only, so the loop is written out by the preprocessor.
#include "occlusion.glsl"
#include "material.glsl"
#include "environment.glsl"

uniform samplerCube lobe_maps[LOBES];
uniform float lobe_scales[LOBES];
uniform float lobe_levels[LOBES];    // log2(texels per radian)
uniform float lobe_exponents[LOBES];

// The cosine below which one pixel cannot tell angles apart: its normals turn by so much. An edge rounded within
// a pixel shows the mean of F over its angles, not the F near 1 of the one that the pixel's middle happens to hit.
float finest_cosine(vec3 n)
{
    vec3 across = dFdx(n), down = dFdy(n);
    return min(0.5 * sqrt(max(dot(across, across), dot(down, down))), 0.7);
}

vec3 reflected_radiance(SurfacePoint p)
{
    vec3 n = p.normal, v = p.view;
    float cos_theta = dot(n, v);
    vec3 r = to_environment(2.0 * cos_theta * n - v);
    vec3 base_gain, gloss_gain;
    fresnel_gains(max(cos_theta, finest_cosine(n)), base_gain, gloss_gain);
    vec3 directional_gain = base_gain * cos_theta;     // N.R = N.V

    vec3 radiance = diffuse.rgb * base_gain * (texture(diffuse_map, to_environment(p.bent)).rgb * diffuse_scale);
    // How far the mirror direction turns from pixel to pixel, in radians; in texels of map k it is 2^lobe_levels[i]
    // times as much, and the mip level follows. Taken once, not per map, and not fooled by the edges of faces.
    vec3 across = dFdx(r), down = dFdy(r);
    float turn = 0.5 * log2(max(max(dot(across, across), dot(down, down)), 1e-12));
#ifdef OCCLUSION
    radiance *= p.occlusion;
#define ARRIVES(k) * specular_occlusion(cos_theta, p.occlusion, lobe_exponents[k])
#else
#define ARRIVES(k)
#endif
#define ADD_LOBE(k) \
    radiance += (lobes[2 * k].rgb * directional_gain + lobes[2 * k + 1].rgb * gloss_gain) \
        * (textureLod(lobe_maps[k], r, turn + lobe_levels[k]).rgb * lobe_scales[k]) ARRIVES(k);
    FOR_EACH_LOBE(ADD_LOBE)
    return light_colour * radiance;
}
