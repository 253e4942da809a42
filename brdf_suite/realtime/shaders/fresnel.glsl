// Provides: float fresnel_dielectric(float cos_theta, float ior)
// Needs:    nothing
//
// Exact reflectance of a smooth dielectric for unpolarized light, from outside (ior >= 1). Schlick's form is
// 22 % too low at 60 degrees for n = 1.5, so it is not used. With c = cos(theta) and g = n cos(theta_t) =
// sqrt(n^2 - 1 + c^2):
//     r_s = (c - g) / (c + g),   r_p = (n^2 c - g) / (n^2 c + g),   F = (r_s^2 + r_p^2) / 2.
float fresnel_dielectric(float cos_theta, float ior)
{
    float c = clamp(cos_theta, 0.0, 1.0);
    float n2 = ior * ior;
    float g = sqrt(max(n2 - 1.0 + c * c, 0.0));
    float s = (c - g) / max(c + g, 1e-6);
    float p = (n2 * c - g) / max(n2 * c + g, 1e-6);
    return 0.5 * (s * s + p * p);
}
