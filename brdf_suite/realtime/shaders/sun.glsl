// Provides: float sun_seen(vec3 position, vec3 normal), sun_direction, sun_irradiance
// Needs:    nothing. Written by lights/sun.py
//
// The share of the environment's sun that a place sees past the mesh, 0 to 1: of its disc, as far as what is in the way
// is away. sun_map has the depth of what the sun sees first, 0 at the near end of a box about the mesh, 1 at its far end.
uniform sampler2D sun_map;
uniform vec3 sun_direction;      // unit, to the sun
uniform vec3 sun_irradiance;     // on what faces it
uniform float sun_spread;        // standard deviation of its directions along an axis, radians
uniform vec4 sun_box;            // middle of the box, half its edge, metres
uniform vec3 sun_right, sun_up;  // unit: the map's axes

const int SUN_TAPS = 12;
const int SUN_SEARCHED = 6;

// Places spread evenly over a disc of radius 1, along a spiral (Vogel 1979).
vec2 on_disc(int k, int count)
{
    float turn = 2.3999632 * float(k);
    return sqrt((float(k) + 0.5) / float(count)) * vec2(cos(turn), sin(turn));
}

float sun_seen(vec3 position, vec3 normal)
{
    float texel = 2.0 / float(textureSize(sun_map, 0).x);        // of the box's half edge
    float cos_sun = dot(normal, sun_direction);
    // A texel's depth belongs to its middle: the place is lifted by as much as the surface rises up to a texel beside it.
    vec3 lifted = position + normal * (sun_box.w * texel * (1.0 + 1.5 * sqrt(max(1.0 - cos_sun * cos_sun, 0.0))))
        - sun_box.xyz;
    vec3 within = vec3(dot(lifted, sun_right), dot(lifted, sun_up), -dot(lifted, sun_direction)) / sun_box.w;
    vec2 place = 0.5 * within.xy + 0.5;
    float depth = 0.5 * within.z + 0.5;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0))))
        return 1.0;
    // Behind the box nothing is nearer than its far end, which stands for nothing.
    float behind = min(depth, 1.0);
    // What is in the way, and how far off: over the largest disc that the sun could be spread to from there.
    float widest = clamp(2.0 * sun_spread * (depth + 0.5), 1.5 * texel, 0.1);
    float nearest = 0.0, met = 0.0;
    for (int k = 0; k < SUN_SEARCHED; ++k)
    {
        float there = textureLod(sun_map, place + 0.5 * widest * on_disc(k, SUN_SEARCHED), 0.0).r;
        if (there < behind)
        {
            nearest += depth - there;
            met += 1.0;
        }
    }
    if (met == 0.0)
        return 1.0;
    // An even disc has twice its standard deviation along an axis as radius; depth counts whole edges, places too.
    float radius = max(2.0 * sun_spread * nearest / met, 0.75 * texel);
    float seen = 0.0;
    for (int k = 0; k < SUN_TAPS; ++k)
    {
        vec2 at = (place + radius * on_disc(k, SUN_TAPS)) * vec2(textureSize(sun_map, 0)) - 0.5;
        vec2 part = fract(at);
        // The map ends beyond the mesh, so its edge is empty.
        ivec2 first = clamp(ivec2(floor(at)), ivec2(0), textureSize(sun_map, 0) - 2);
        // Each of four texels is in the way or not, and counts by how near it is.
        vec4 open = vec4(greaterThanEqual(vec4(texelFetch(sun_map, first, 0).r,
                                               texelFetch(sun_map, first + ivec2(1, 0), 0).r,
                                               texelFetch(sun_map, first + ivec2(0, 1), 0).r,
                                               texelFetch(sun_map, first + ivec2(1, 1), 0).r),
                                          vec4(behind)));
        vec2 rows = mix(open.xz, open.yw, part.x);
        seen += mix(rows.x, rows.y, part.y);
    }
    return seen / float(SUN_TAPS);
}
