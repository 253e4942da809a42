// Provides: float specular_occlusion(float cos_theta, float occlusion, float exponent)
// Needs:    nothing
//
// Which share of a lobe's light arrives where only the share "occlusion" (0 to 1) of a uniform light's irradiance
// does (Lagarde and de Rousiers 2014): sat(pow(N.V + ao, exp2(-16 r - 1)) - 1 + ao). 1 for an open place at any
// roughness; for a rough lobe the occlusion itself, for a sharp one less, the more so the steeper the view.
// r is the width of the facets' slopes: a lobe (R.V)^E has E = 1 / (2 r^2).
float specular_occlusion(float cos_theta, float occlusion, float exponent)
{
    float r = min(inversesqrt(2.0 * exponent), 1.0);
    return clamp(pow(cos_theta + occlusion, exp2(-16.0 * r - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}
