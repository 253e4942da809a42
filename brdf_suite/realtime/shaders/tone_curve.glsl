// Provides: TONE_NEUTRAL, TONE_CHARACTERISTIC, TONE_LINEAR, TONE_FAITHFUL, TONE_ACES, TONE_AGX,
//           vec3 tone_curve(vec3 c, int kind)
// Needs:    nothing
//
// Exposed radiance of the working space in, display light of the working space out (0 to 1 except for linear,
// which is clipped later). The same functions in numpy, with their sources: tone_curves.py.
const int TONE_NEUTRAL = 0;
const int TONE_CHARACTERISTIC = 1;
const int TONE_LINEAR = 2;
const int TONE_FAITHFUL = 3;
const int TONE_ACES = 4;
const int TONE_AGX = 5;

// One to one up to start, then a shoulder that goes to white, of the slope 1 where it begins (Khronos's).
vec3 tone_shoulder(vec3 c, float start)
{
    float peak = max(c.r, max(c.g, c.b));
    if (peak <= start)
        return c;
    float room = 1.0 - start;
    float compressed = 1.0 - room * room / (peak + room - start);
    float g = 1.0 / (0.15 * (peak - compressed) + 1.0);
    return mix(vec3(compressed), c * (compressed / peak), g);
}

// What is in the scene is what is shown, up to 0.8: a colour reads as it was measured, and the few percent that
// a clearcoat reflects stay.
vec3 tone_faithful(vec3 c)
{
    return tone_shoulder(c, 0.8);
}

// Khronos PBR Neutral: takes the 4 % off that a dielectric reflects, so that a base colour reads as its texture.
vec3 tone_neutral(vec3 c)
{
    float x = min(c.r, min(c.g, c.b));
    return tone_shoulder(c - (x <= 0.08 ? x - x * x / 0.16 : 0.04), 0.76);
}

// The characteristic curve of film, a sigmoid in log exposure, for each channel: 1 / (1 + (k / c)^slope) with
// k such that 0.18 stays 0.18, and the slope such that contrast there is 1 (slope (1 - 0.18) = 1).
vec3 tone_characteristic(vec3 c)
{
    const float slope = 1.0 / 0.82;
    const float k = 0.6241319;                          // 0.18 (0.82 / 0.18)^(1 / slope)
    vec3 x = pow(max(c, 0.0) / k, vec3(slope));
    return x / (1.0 + x);
}

// ACES: into AP1 at 96 % saturation, Hill's fit of the reference and output curves, back at 93 %.
vec3 tone_aces(vec3 c)
{
    const mat3 into = mat3(0.94658403, 0.01277723, 0.01529020,
                           0.04592414, 0.98282304, 0.05065973,
                           0.00749184, 0.00439973, 0.93405007);
    const mat3 back = mat3(0.97307303, 0.01697805, 0.01439359,
                           0.02853626, 0.98145117, 0.02366596,
                           -0.00160928, 0.00157078, 0.96194045);
    vec3 v = into * c;
    // Divided by v, which may be too large for its square.
    vec3 fitted = (v + 0.0245786 - 0.000090537 / max(v, 1e-9)) / (0.983729 * v + 0.432951 + 0.238081 / max(v, 1e-9));
    return back * max(fitted, 0.0);
}

// A curve from 0 that leaves the pivot with the slope 2 and comes to rest at 1 after the distance to its end.
vec3 tone_agx_branch(vec3 distance_from_pivot, float scale, float power)
{
    vec3 t = 2.0 * distance_from_pivot / scale;
    return scale * t / pow(1.0 + pow(t, vec3(power)), vec3(1.0 / power));
}

// AgX: 16.5 stops in logarithm, channels drawn together, a sigmoid, and drawn apart again.
vec3 tone_agx(vec3 c)
{
    const mat3 inset = mat3(0.856627153, 0.137318973, 0.111898213,
                            0.095121241, 0.761241991, 0.076799418,
                            0.048251606, 0.101439036, 0.811302368);
    const mat3 outset = mat3(1.127100582, -0.141329763, -0.141329763,
                             -0.110606643, 1.157823702, -0.110606643,
                             -0.016493939, -0.016493939, 1.251936407);
    const float pivot = 20.0 / 33.0;
    vec3 x = clamp((log2(max(inset * c, 1e-10)) + 12.473931188) / 16.5, 0.0, 1.0);
    vec3 toe = tone_agx_branch(max(pivot - x, 0.0), 0.512277382, 3.0);
    vec3 shoulder = tone_agx_branch(max(x - pivot, 0.0), 0.541464156, 3.25);
    return pow(clamp(outset * (0.5 + shoulder - toe), 0.0, 1.0), vec3(2.2));  // the outset leaves 0 to 1
}

vec3 tone_curve(vec3 c, int kind)
{
    c = min(c, vec3(1e6));                              // an infinite radiance must not become a NaN
    if (kind == TONE_NEUTRAL)
        return tone_neutral(c);
    if (kind == TONE_FAITHFUL)
        return tone_faithful(c);
    if (kind == TONE_CHARACTERISTIC)
        return tone_characteristic(c);
    if (kind == TONE_ACES)
        return tone_aces(c);
    if (kind == TONE_AGX)
        return tone_agx(c);
    return c;
}
