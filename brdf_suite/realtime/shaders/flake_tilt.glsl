// Provides: vec2 flake_slope(vec3 to_light, vec3 to_eye, float ior), vec3 tilt_place(vec2 slope, float roughness),
//           float beckmann_slopes(float slope2, float roughness), float ggx_density(float slope2, float roughness),
//           float tilt_bell(float slope2, float roughness)
// Needs:    nothing. The same functions in numpy: appearance/flakes/tilt.py
//
// Directions are of the local frame, z the normal, away from the surface.

// The slope of the flake below the coat that mirrors light to the eye. Inside the coat the part of a direction across
// the normal is 1 / n of that outside (Snell); the flake's normal is along the sum of the two.
vec2 flake_slope(vec3 to_light, vec3 to_eye, float ior)
{
    float n2 = ior * ior;
    float up = sqrt(n2 - dot(to_light.xy, to_light.xy)) + sqrt(n2 - dot(to_eye.xy, to_eye.xy));
    return (to_light.xy + to_eye.xy) / max(up, 1e-6);
}

// How many flakes have a tilt, per solid angle, over those that lie flat: Beckmann's slopes,
//     exp(-s^2 / m^2) (1 + s^2)^(3/2);  over (pi m^2) it is their density per solid angle.
float tilt_bell(float slope2, float roughness)
{
    float up = 1.0 + slope2;
    return exp(-slope2 / (roughness * roughness)) * up * sqrt(up);
}

// Where a slope lies on the unit square (xy), and how much a small angle is stretched there (z, 1/rad): on a disc of
// diameter 1 whose even points are tilts of that density, radius^2 = (1 - exp(-s^2 / m^2)) / 4.
vec3 tilt_place(vec2 slope, float roughness)
{
    vec2 wide = slope / roughness;
    float wide2 = dot(wide, wide);
    float falls = exp(-wide2);
    float grows = wide2 < 1e-3 ? 1.0 - 0.5 * wide2 : (1.0 - falls) / wide2;
    float up = 1.0 + dot(slope, slope);
    return vec3(0.5 + wide * (0.5 * sqrt(grows)), 0.5 / roughness * sqrt(falls * up * sqrt(up)));
}

// Densities over the slope: of Beckmann's surface, exp(-s^2 / m^2) / (pi m^2); and over solid angle, GGX:
// (1 + s^2)^2 / (pi m^2 (1 + s^2/m^2)^2).
float beckmann_slopes(float slope2, float roughness)
{
    float m2 = roughness * roughness;
    return exp(-slope2 / m2) / (3.14159265 * m2);
}

float ggx_density(float slope2, float roughness)
{
    float m2 = roughness * roughness;
    float ratio = (1.0 + slope2) / (1.0 + slope2 / m2);
    return ratio * ratio / (3.14159265 * m2);
}
