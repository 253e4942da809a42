// Provides: vec3 grain_difference(SurfacePoint p, FlakePlace place, vec3 base_gain, vec3 radiance)
// Needs:    surface_point.glsl, flake_place.glsl, material.glsl, lights.glsl, light_lobes.glsl, and the uniforms flakes
//           and flake_optics; its own are written by lights/mosaic.py
//
// The grain of a full population of flakes in all the light of the environment. A flake mirrors what lies in the
// direction that its tilt sends the eye to; how far its light is from the mean of all flakes is what is added:
//     sum over four tilts t of A(t) L(t) (m_t - 1/4)
// with L the light about the mirrored direction, A what a flake makes of it, and m_t the share of the footprint's light
// that flakes of that tilt have, each by its brightness. Their mean is 1/4, so nothing is added on the average, whatever
// the light. The four tilts lie on the corners of a square, whose variance is that of all tilts, where the light changes
// evenly over them. Where it does not, the variance over all tilts is known from its second moment
// (lights/tilt_light.py): the four are drawn apart or together until theirs is the same, and what they cannot show is
// given to them in turn, as the mirrored direction turns.
//
// Small bright lights are left to sparkle_glints.glsl: what the looked-up maps have of them is taken out.
//
// m comes from a mosaic that repeats (mosaic.frag.glsl), filtered over the footprint by its mip levels: the contrast
// falls as one over the root of the flakes seen, and nothing flickers. Two of it lie turned over each other, so that no
// eye finds the repetition.
#include "flake_tilt.glsl"
#include "lobe_stack.glsl"
#include "environment.glsl"

uniform sampler2D flake_mosaic;
uniform vec4 mosaic_mean;       // of its channels, about 1/4
uniform vec4 grain;             // tiles per mm; contrast over that of full coverage; slice of the stack that is looked
                                // up, and its exponent

uniform sampler3D tilt_light;   // means of the light and of its square over lobes of directions
uniform vec2 tilt_square;       // place in [-1, 1] times x plus y: texture coordinate

// Where the tilts lie, over the roughness, along each axis: at the standard deviation; and the footprint, in tiles, above which there is no grain to be seen.
const float GRAIN_TILT = 0.70710678;
// By how much the four may be drawn apart.
const float MOST_DRAWN = 2.0;
const vec3 GRAIN_LUMINANCE = vec3(0.2627, 0.678, 0.0593);
// The dimmest of the four, over their mean: below -1 what is left is made up by light that no flake sends.
const float LEAST_FLAKE = -1.5;
// Flakes send at most so much of all that is seen.
const float MOST_GRAIN = 0.6;
const float GRAIN_FADES = 0.5, GRAIN_ENDS = 1.0;

vec4 mosaic_difference(vec2 at, float level)
{
    return textureLod(flake_mosaic, at, level) - mosaic_mean;
}

// The means of the light of single flakes and of its square. The directions that flakes of the spread m send the eye to
// lie in a lobe of the exponent 1 / (2 n^2 m^2).
vec2 light_moments(vec3 mirror, float exponent)
{
    float slices = float(TILT_SLICES);
    float level = (clamp(log2(exponent) - 1.0, 0.0, slices - 1.0) + 0.5) / slices;
    return texture(tilt_light, vec3(to_square(mirror) * tilt_square.x + tilt_square.y, level)).rg;
}

vec3 grain_difference(SurfacePoint p, FlakePlace place, vec3 base_gain, vec3 radiance)
{
    vec2 at = place.at * grain.x, across = place.across * grain.x, down = place.down * grain.x;
    float widest = sqrt(max(dot(across, across), dot(down, down)));
    float near = 1.0 - smoothstep(GRAIN_FADES, GRAIN_ENDS, widest);
    if (near <= 0.0)
        return vec3(0.0);
    const mat2 turned = mat2(0.8, 0.6, -0.6, 0.8);
    // The level whose texels are as wide as the pixel.
    float level = log2(max(widest * float(MOSAIC_TEXELS), 1.0));
    vec4 shares = mosaic_difference(at, level) + mosaic_difference(turned * at + vec2(0.37, 0.61), level);
    shares *= 0.70710678 * grain.y * near;

    mat3 to_local = local_frame(p.normal);
    vec3 to_eye = to_local * p.view;
    float n2 = flake_optics.x * flake_optics.x;
    vec3 below = vec3(to_eye.xy, sqrt(max(n2 - dot(to_eye.xy, to_eye.xy), 1e-6)));
    float tilt = GRAIN_TILT * flakes.z;
    // As long as the normal of a flake is: 1, and twice the square of a tilt along an axis.
    float over = 2.0 / (1.0 + 2.0 * tilt * tilt);
    // In the base's hue at the angle that such tilts see about the mirror direction.
    vec3 hue = flake_lobe(2.0 * flake_optics.x * 1.4142136 * tilt);
    vec3 power = hue * (flake_optics.w / max(largest(hue), 1e-9));
    vec3 towards[4], sends[4], mirrored[4];
    for (int q = 0; q < 4; ++q)
    {
        vec3 flake = vec3(tilt * float(2 * (q & 1) - 1), tilt * float((q & 2) - 1), 1.0);
        vec3 light = over * dot(below, flake) * flake - below;
        float out_of = 1.0 - dot(light.xy, light.xy);
        vec3 to_light = vec3(light.xy, sqrt(max(out_of, 0.0)));
        towards[q] = transpose(to_local) * to_light;
        mirrored[q] = light_colour * broad_light(to_environment(towards[q]), grain.z);
        // What would leave the coat at more than a right angle stays in it.
        sends[q] = out_of > 0.0 && light.z > 0.0 ? power : vec3(0.0);
    }
    // Without what the maps have of small bright lights.
    for (int i = 0; i < int(light_counts.x); ++i)
    {
        Arriving light = light_at(i, p.position);
        vec4 cosines = vec4(dot(light.direction, towards[0]), dot(light.direction, towards[1]),
                            dot(light.direction, towards[2]), dot(light.direction, towards[3]));
        if (any(greaterThan(cosines, vec4(0.9))))
        {
            vec4 found = (grain.w + 1.0) * 0.15915494 * pow(max(cosines, 0.0), vec4(grain.w));
            for (int q = 0; q < 4; ++q)
                mirrored[q] -= light.irradiance * found[q];
        }
    }
    vec3 middle = vec3(0.0), sent = vec3(0.0);
    for (int q = 0; q < 4; ++q)
    {
        mirrored[q] = sends[q] * max(mirrored[q], 0.0);
        middle += 0.25 * mirrored[q];
        sent += 0.25 * sends[q];
    }
    vec3 mirror = to_environment(2.0 * dot(p.normal, p.view) * p.normal - p.view);
    float exponent = 0.5 / (n2 * flakes.z * flakes.z);
    vec2 moments = light_moments(mirror, exponent);
    // Of the colour that the four have, where any of them is lit.
    float lit = dot(middle, GRAIN_LUMINANCE);
    vec3 grey = sent * (light_colour * vec3(moments.x));
    float all = dot(grey, GRAIN_LUMINANCE);
    vec3 mean = lit > 1e-3 * all ? middle * (all / lit) : grey;
    float whole = max(dot(mean, GRAIN_LUMINANCE), 1e-9);
    vec4 apart = (vec4(dot(mirrored[0], GRAIN_LUMINANCE), dot(mirrored[1], GRAIN_LUMINANCE),
                       dot(mirrored[2], GRAIN_LUMINANCE), dot(mirrored[3], GRAIN_LUMINANCE))
                  - lit) / whole;
    float found = 0.25 * dot(apart, apart);
    float wanted = max(moments.y / max(moments.x * moments.x, 1e-12) - 1.0, 0.0);
    float drawn = min(sqrt(wanted / max(found, 1e-4)), MOST_DRAWN);
    float rest = sqrt(max(wanted - drawn * drawn * found, 0.0));
    float phase = dot(mirror, vec3(29.0, 37.0, 23.0));
    vec4 turn = max(vec4(cos(phase), sin(phase), -cos(phase), -sin(phase)), 0.0);
    turn *= turn;
    turn *= turn;
    turn *= turn;
    turn *= 4.0 / dot(turn, vec4(1.0));        // mostly one of the four, of mean 1
    vec4 relative = drawn * apart + rest * inversesqrt(0.25 * dot(turn, turn) - 1.0) * (turn - 1.0);
    // Scaled to the variance that is wanted, as far as no flake takes much light away.
    float least = min(min(relative.x, relative.y), min(relative.z, relative.w));
    float kept = min(sqrt(wanted / max(0.25 * dot(relative, relative), 1e-6)), LEAST_FLAKE / min(least, -1e-6));
    vec3 sum = vec3(0.0);
    for (int q = 0; q < 4; ++q)
        sum += shares[q] * (mean * (1.0 + kept * (relative[q] - drawn * apart[q])) + kept * drawn * (mirrored[q] - middle));
    // Four directions may find more light than there is about them.
    vec3 share = base_gain * p.occlusion;
    float most = MOST_GRAIN * largest(radiance) / max(largest(mean * share), 1e-12);
    return min(most, 1.0) * share * sum;
}
