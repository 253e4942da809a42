// Provides: struct Footprint, Footprint flake_footprint(vec2 at, vec2 across, vec2 down, float size),
//           float flake_cover(Footprint f, vec2 apart)
// Needs:    nothing
//
// What one pixel sees of a flake, as a density over where the flake lies. The pixel is an ellipse on the surface,
// a flake a disc; together they have the covariance
//     S = w^2 J J^T + (size / 4)^2 I,   J = (across, down): millimetres on the surface per pixel,
// w the pixel's reach in standard deviations; a disc of diameter s has the variance s^2 / 16 along each axis. With
// t = d^T S^-1 d the density falls from t = 4 - e to 4 + e, and is the same with its mirror image about t = 4, so
//     k(t) = (1 - smoothstep(4 - e, 4 + e, t)) / (4 pi sqrt(det S))
// has the integral 1 for any e: a disc of S's size where flakes are large (e near 0, an edge of a pixel and a half),
// a soft spot where they are small (e = 4). It ends at t = 8, so nothing is ever cut off.
const float PIXEL_REACH = 0.43;
const float FOOTPRINT_END = 2.8284271;      // sqrt(8) standard deviations

struct Footprint
{
    vec2 at;               // mm on the surface
    vec3 inverse;          // of S: xx, xy, yy
    float height;          // 1 / (4 pi sqrt(det S)), 1/mm^2
    float edge;            // e
    float widest;          // standard deviation along the longer axis, mm
    vec2 reach;            // how far it ends along each axis, mm
};

Footprint flake_footprint(vec2 at, vec2 across, vec2 down, float size)
{
    float own = 0.0625 * size * size;
    vec3 pixel = PIXEL_REACH * PIXEL_REACH
        * vec3(across.x * across.x + down.x * down.x, across.x * across.y + down.x * down.y,
               across.y * across.y + down.y * down.y);
    vec3 s = vec3(pixel.x + own, pixel.y, pixel.z + own);
    float half_sum = 0.5 * (s.x + s.z);
    float half_gap = length(vec2(0.5 * (s.x - s.z), s.y));
    float large = half_sum + half_gap;
    float det = max(large * max(half_sum - half_gap, own), 1e-20);
    float sharpest = sqrt(max(large - own, 0.0) / large);
    return Footprint(at, vec3(s.z, -s.y, s.x) / det, 0.079577472 * inversesqrt(det),
                     4.0 * clamp(1.5 * sharpest, 0.01, 1.0), sqrt(large), FOOTPRINT_END * sqrt(s.xz));
}

float flake_cover(Footprint f, vec2 apart)
{
    float t = apart.x * (f.inverse.x * apart.x + 2.0 * f.inverse.y * apart.y) + f.inverse.z * apart.y * apart.y;
    float x = clamp((4.0 + f.edge - t) / (2.0 * f.edge), 0.0, 1.0);
    return f.height * x * x * (3.0 - 2.0 * x);
}
