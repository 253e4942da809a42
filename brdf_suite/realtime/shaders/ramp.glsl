// Provides: uniform sampler2D ramp, float seen_cosine(SurfacePoint p), float finest_cosine(SurfacePoint p),
//           float ramp_coordinate(float c), vec4 ramp_row(float coordinate, int row)
// Needs:    surface_point.glsl; MAX_BROAD, MAX_SHARP, RAMP_ROWS, RAMP_NODES (written by shader_source.py)
//
// What of a material depends on c = N.V alone: weights, gains and exponents over the root of c, a row for each look-up
// (material/ramp.py).
#include "material.glsl"

uniform sampler2D ramp;

// The cosine below which one pixel cannot resolve angles: its normals turn by so much. An edge rounded within
// a pixel shows the mean of F over its angles, not the F near 1 of the one that the pixel's middle happens to hit.
float finest_cosine(SurfacePoint p)
{
    vec3 across = ACROSS(p.normal, p.normal_across), down = DOWN(p.normal, p.normal_down);
    return min(0.5 * sqrt(max(dot(across, across), dot(down, down))), 0.7);
}

float ramp_coordinate(float c)
{
    return (sqrt(clamp(c, 0.0, 1.0)) * float(RAMP_NODES - 1) + 0.5) / float(RAMP_NODES);
}

vec4 ramp_row(float coordinate, int row)
{
    return textureLod(ramp, vec2(coordinate, (float(row) + 0.5) / float(RAMP_ROWS)), 0.0);
}

float seen_cosine(SurfacePoint p)
{
    return max(dot(p.normal, p.view), finest_cosine(p));
}
