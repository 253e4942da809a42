// Provides: uniform block Material (one buffer per material), COAT_NONE, COAT_DIELECTRIC, COAT_METAL, COAT_FACETS, COAT_SHEET,
//           void fresnel_gains(float cos_theta, out vec3 base_gain, out vec3 gloss_gain)
// Needs:    MAX_BROAD (written by shader_source.py); FRESNEL_RAISED where the gains follow the angle
#include "fresnel.glsl"

const int COAT_NONE = 0;
const int COAT_DIELECTRIC = 1;
const int COAT_METAL = 2;
const int COAT_FACETS = 3;
const int COAT_SHEET = 4;

// Written whole by material/material_set.py (std140). The weights are in the ramp, see lobes.glsl; a fit leaves most at zero,
// and only lobes with a weight are looked up.
layout(std140) uniform Material
{
    ivec4 look_ups;            // x: broad lobes of the base, y: those and the coat's, z: sharp lobes
    vec4 coat;                 // x: COAT_*, y: index of refraction, z: 1 / F(theta_fit), w: 1 / T(theta_fit)^2
    vec4 gloss_albedo;         // rgb: sum of the gloss weights; a: 1 / (largest of them), the limit of the gain
    vec4 broad[MAX_BROAD];     // xyz: how far N draws a look-up from R, over 1, c, c^2, c = N.V; w: exponent of the lobe,
                               // negative where the look-up is drawn from -R
};

// Which share of base and gloss is seen at the view angle theta, relative to the incidence of the fit.
//
// The fit approximates f_r cos(theta_i), cosine included, by sum KG_i (R.V)^E_i at theta_fit. A smooth mirror
// coat has f_r cos(theta_i) = F(theta) delta(l - r): the cosine of the BRDF's 1/cos and the one of the
// rendering equation cancel, at every angle. Its integral over light is F, so the fit gives
//     G = sum KG_i 2 pi / (E_i + 1) = F(theta_fit),
// and the radiance reflected from surroundings L is, with unit-gain maps, G P(R) = F(theta_fit) L(R). The gain
//     F(theta) / F(theta_fit)
// therefore makes it F(theta) L(R) exactly: F(0) at normal incidence, 1 at grazing, with no further cosine.
// A coat whose G is above F(theta_fit), by an imprecise fit, is limited so that G times the gain is at most 1.
//
// Light that comes from the base crossed the coat twice, hence T(theta)^2 / T(theta_fit)^2, T = 1 - F.
//
// A thin sheet mirrors at both faces, again and again: R = 2 F / (1 + F) stands in the place of F; it has no base.
//
// Facet lobes of a sum (Cook-Torrance) gain by F too, but take nothing from the base: it stays.
//
// A metal has no base to lower, and its reflectance rises from G to 1, not by a ratio:
//     G + (1 - G) (1 - cos(theta))^5 for each channel (Schlick's form, which is meant for metals).
void fresnel_gains(float cos_theta, out vec3 base_gain, out vec3 gloss_gain)
{
    base_gain = vec3(1.0);
    gloss_gain = vec3(1.0);
#ifdef FRESNEL_RAISED
    int kind = int(coat.x);
    if (kind == COAT_DIELECTRIC || kind == COAT_FACETS || kind == COAT_SHEET)
    {
        float f = fresnel_dielectric(cos_theta, coat.y);
        if (kind == COAT_SHEET)
            f = 2.0 * f / (1.0 + f);
        float t = 1.0 - f;
        if (kind == COAT_DIELECTRIC)
            base_gain = vec3(t * t * coat.w);
        gloss_gain = vec3(min(f * coat.z, max(gloss_albedo.a, 1.0)));
    }
    else if (kind == COAT_METAL)
    {
        float s = clamp(1.0 - cos_theta, 0.0, 1.0);
        float rise = s * s * s * s * s;
        vec3 g = max(gloss_albedo.rgb, vec3(1e-4));
        gloss_gain = (g + max(1.0 - g, 0.0) * rise) / g;
    }
#endif
}
