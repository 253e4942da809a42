// Provides: the exposed light of what is seen past the surface: the environment, sharp or blurred, or a plain colour
// Needs:    screen.vert.glsl
#include "environment.glsl"
#include "lobe_stack.glsl"
#include "exposed.glsl"

uniform mat3 view_to_world;
uniform vec2 half_tangents;      // tangents of half the horizontal and vertical field of view
uniform vec2 lens_shift;         // tangents by which the middle of the picture lies aside of the axis
uniform vec4 frame;              // xy: this tile's corner in the whole picture, zw: 1 / size of the whole picture
uniform int backdrop;            // BACKDROP_*
uniform vec3 backdrop_colour;    // working space, after the exposure
uniform float backdrop_level;    // of the stack, of the lobe that blurs

const int BACKDROP_SHARP = 0, BACKDROP_BLURRED = 1, BACKDROP_PLAIN = 2;

out vec4 fragment;

// The environment between its texels by the cubic B-spline, which has no steps and no corners: it is never negative and
// keeps the sum of the light, so that a lamp gets neither a dark rim nor another brightness. Each of its 16 texels is
// looked up at its centre: graphics cards place a look-up between texels in steps of 1/256, which show when a texel is
// many pixels wide.
vec3 smooth_map(vec3 along, float texels)
{
    vec3 size = abs(along);
    float longest = max(size.x, max(size.y, size.z));
    vec3 place = along / longest;  // on the cube whose faces are 1 away
    bool on_x = size.x == longest, on_y = !on_x && size.y == longest;
    vec3 across = on_x ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 up = on_y ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
    vec3 outwards = place * (vec3(1.0) - across - up);
    vec2 middle = vec2(dot(place, across), dot(place, up));
    vec2 at = (middle * 0.5 + 0.5) * texels - 0.5;
    vec2 f = fract(at), g = 1.0 - f;
    vec2 first = g * g * g / 6.0, last = f * f * f / 6.0;
    vec2 second = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f), third = 1.0 - first - second - last;
    vec4 columns = vec4(first.x, second.x, third.x, last.x), rows = vec4(first.y, second.y, third.y, last.y);
    float step = 2.0 / texels;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        int column = i & 3, row = i >> 2;
        vec2 offset = (vec2(float(column), float(row)) - 1.0 - f) * step;
        float weight = columns[column] * rows[row];
        // Past the rim it goes on round the edge of the cube, where the rows of texels meet those of the next face.
        vec2 there = middle + offset, past = max(abs(there) - 1.0, 0.0);
        there = clamp(there, -1.0, 1.0);
        vec3 direction = outwards * (1.0 - past.x - past.y) + there.x * across + there.y * up;
        sum += weight * textureLod(background_map, direction, 0.0).rgb;
    }
    return sum;
}

vec3 sharp_background(vec3 direction)
{
    float texels = float(textureSize(background_map, 0).x);
    // The texels that a pixel in the middle covers: from one on, the map is not enlarged and stays as sharp as it is.
    float covered = half_tangents.y * frame.w * texels;
    float enlarged = 1.0 - smoothstep(0.5, 1.0, covered);
    vec3 plain = background_radiance(direction);
    if (enlarged == 0.0)
        return plain;
    vec3 smoothed = light_colour * (smooth_map(to_environment(direction), texels) * background_scale);
    return mix(plain, smoothed, enlarged);
}

void main()
{
    vec2 ndc = (gl_FragCoord.xy + frame.xy) * frame.zw * 2.0 - 1.0;
    vec3 direction = view_to_world * vec3(ndc * half_tangents + lens_shift, -1.0);
    // A plain backdrop looks the same at any exposure, so it does not change when the light is dimmed.
    vec3 radiance = backdrop_colour / exposure;
    if (backdrop == BACKDROP_BLURRED)
        radiance = light_colour * broad_light(to_environment(direction), backdrop_level);
    else if (backdrop == BACKDROP_SHARP)
        radiance = sharp_background(direction);
    fragment = vec4(exposed_light(radiance), 0.0);
}
