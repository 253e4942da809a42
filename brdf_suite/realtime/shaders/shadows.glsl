// Provides: float light_seen(int which, vec3 position, vec3 normal, bool wanted); with SUN: SUN_SHADOW, sun_direction,
//           sun_irradiance; FIRST_LAMP_SHADOW
// Needs:    SUN, LAMP_SHADOWS or both; PANE_SHADOWS where there are panes. Written by lights/shadows.py
//
// The share of a light that a place sees past the mesh, 0 to 1: of its disc, as far as what is in the way is away.
// Every light has a tile of one map, with the depth of what it sees first: a distant light in parallel, a near one in
// perspective from its middle. Panes have another map: what all of them pass that are nearer than that, and how near the
// first of them is.
const int MOST_SHADOWS = 9;                  // the sun and eight lamps
uniform sampler2D shadow_map;
#ifdef PANE_SHADOWS
uniform sampler2D pane_map;
const float BEHIND_PANE = 2e-3;      // of the depth, so that a pane does not shade itself

// What panes leave of a light at a place of a tile, of a depth 0 to 1.
float passed_by_panes(vec4 tile, vec2 place, float depth)
{
    vec2 at = tile.xy + clamp(place * tile.z, vec2(0.5), vec2(tile.z - 0.5));
    vec4 pane = texture(pane_map, at / vec2(textureSize(pane_map, 0)));
    return depth > pane.a + BEHIND_PANE ? pane.r : 1.0;
}
#else
#define passed_by_panes(tile, place, depth) 1.0
#endif
// World to the tile: place 0 to 1 times w; distance along the axis, metres; w, which is 1 for a distant light, that
// distance for a near one.
uniform mat4 shadow_to_tile[MOST_SHADOWS];
uniform vec4 shadow_tile[MOST_SHADOWS];      // lower left corner and edge, texels; w: 1 for a near light
uniform vec4 shadow_from[MOST_SHADOWS];      // unit, to a distant light, or place of a near one, metres
// Nearest and farthest distance along the axis, metres; radius of the light's disc, radians of a distant light, metres
// of a near one; width of the tile, metres, of a near light at a distance of 1 m.
uniform vec4 shadow_range[MOST_SHADOWS];

#ifdef SUN
const int SUN_SHADOW = 0;
const int FIRST_LAMP_SHADOW = 1;
uniform vec3 sun_direction;      // unit, to the sun
uniform vec3 sun_irradiance;     // on what faces it
#else
const int FIRST_LAMP_SHADOW = 0;
#endif

const int SHADOW_TAPS = 12;
const int SHADOW_SEARCHED = 8;
const int SHARP_TAPS = 1;            // of a light without extent
const float WIDEST_SEARCH = 0.1;     // of a tile
const float STEEPEST = 8.0;          // of a plane's depth over its place in the tile

// Places spread evenly over a disc of radius 1, along a spiral (Vogel 1979).
vec2 on_disc(int k, int count)
{
    float turn = 2.3999632 * float(k);
    return sqrt((float(k) + 0.5) / float(count)) * vec2(cos(turn), sin(turn));
}

// Place in the tile, 0 to 1, and depth there as the map has it, 0 to 1, of a point of to_tile.
vec3 in_tile(vec4 at, vec4 range, bool near)
{
    float along = near ? range.y / max(at.z, 1e-9) : 1.0;
    return vec3(at.xy / at.w, along * (at.z - range.x) / (range.y - range.x));
}

// How the depth of a plane through `here` and two other points changes over the tile.
vec2 plane_slope(vec3 here, vec3 one, vec3 other)
{
    vec3 a = one - here, b = other - here;
    float area = a.x * b.y - a.y * b.x;
    vec2 slope = vec2(b.y * a.z - a.y * b.z, a.x * b.z - b.x * a.z) / (abs(area) > 1e-20 ? area : 1e20);
    return slope * min(1.0, STEEPEST * inversesqrt(max(dot(slope, slope), 1e-12)));
}

// Nothing is found for a place that is not `wanted`: a software renderer, which passes over no branch, leaves a loop
// that no place stays in.
float light_seen(int which, vec3 position, vec3 normal, bool wanted)
{
    vec4 tile = shadow_tile[which], from = shadow_from[which], range = shadow_range[which];
    mat4 to_tile = shadow_to_tile[which];
    bool near = tile.w > 0.5, sharp = range.z <= 0.0;
    float texel = 1.0 / tile.z;
    vec3 way = near ? from.xyz - position : from.xyz;
    float cos_light = dot(normal, way) * inversesqrt(max(dot(way, way), 1e-12));
    // A texel's depth belongs to its middle: the place is lifted by as much as the surface rises up to a texel beside it.
    float wide = range.w * abs((to_tile * vec4(position, 1.0)).w) * texel;
    vec3 lifted = position + wide * (1.0 + 1.5 * sqrt(max(1.0 - cos_light * cos_light, 0.0))) * normal;
    vec4 at = to_tile * vec4(lifted, 1.0);
    vec3 here = in_tile(at, range, near);
    vec2 place = here.xy;
    bool within = wanted && at.w > 0.0 && all(greaterThanEqual(place, vec2(0.0)))
        && all(lessThanEqual(place, vec2(1.0)));
    // The surface goes on as a plane: what of it is nearer to the light is not in the way.
    vec3 aside = 8.0 * wide * normalize(abs(normal.x) < 0.7 ? vec3(0.0, normal.z, -normal.y) : vec3(-normal.z, 0.0, normal.x));
    vec2 slope = sharp ? vec2(0.0)
                       : plane_slope(here, in_tile(to_tile * vec4(lifted + aside, 1.0), range, near),
                                     in_tile(to_tile * vec4(lifted + cross(normal, aside), 1.0), range, near));
    // The largest disc that the light could be spread to, from what is nearest to it.
    float scale = range.z / (range.w * (near ? at.z : 1.0));
    float farthest = scale * (at.z - range.x) / (near ? range.x : 1.0);
    float searched = clamp(farthest, 0.75 * texel, WIDEST_SEARCH);
    float spread = 0.0, met = 0.0;
    int looks = within && !sharp ? SHADOW_SEARCHED : 0;
    ivec2 last = ivec2(int(tile.z) - 2);
    for (int k = 0; k < looks; ++k)
    {
        vec2 off = searched * on_disc(k, SHADOW_SEARCHED);
        float there = texelFetch(shadow_map, ivec2(tile.xy) + clamp(ivec2((place + off) * tile.z), ivec2(0), last + 1), 0).r;
        // Nothing is nearer than the map's far end where it has seen nothing.
        if (there < min(here.z + dot(slope, off), 1.0))
        {
            float away = near ? range.x * range.y / (range.y - there * (range.y - range.x))
                              : mix(range.x, range.y, there);
            spread += scale * max(at.z - away, 0.0) / (near ? away : 1.0);
            met += 1.0;
        }
    }
    float radius = sharp ? 0.0 : max(spread / max(met, 1.0), 0.75 * texel);
    int taps = sharp ? SHARP_TAPS : SHADOW_TAPS;
    int taken = within && (sharp || met > 0.0) ? taps : 0;
    float open = 0.0;
    for (int k = 0; k < taken; ++k)
    {
        vec2 off = radius * on_disc(k, taps);
        vec2 on = (place + off) * tile.z - 0.5;
        vec2 part = fract(on);
        // The tile ends beyond the mesh, so its edge is empty.
        ivec2 first = ivec2(tile.xy) + clamp(ivec2(floor(on)), ivec2(0), last);
        // Each of four texels is in the way or not, and counts by how near it is.
        vec4 clear = vec4(greaterThanEqual(vec4(texelFetch(shadow_map, first, 0).r,
                                                texelFetch(shadow_map, first + ivec2(1, 0), 0).r,
                                                texelFetch(shadow_map, first + ivec2(0, 1), 0).r,
                                                texelFetch(shadow_map, first + ivec2(1, 1), 0).r),
                                           vec4(min(here.z + dot(slope, off), 1.0))));
        vec2 rows = mix(clear.xz, clear.yw, part.x);
        open += mix(rows.x, rows.y, part.y) * passed_by_panes(tile, place + off, here.z + dot(slope, off));
    }
    if (taken > 0)
        return open / float(taps);
    return within ? passed_by_panes(tile, place, here.z) : 1.0;
}
