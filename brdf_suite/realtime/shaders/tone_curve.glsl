// Provides: TONE_NEUTRAL, TONE_CHARACTERISTIC, TONE_LINEAR, TONE_FAITHFUL, vec3 tone_curve(vec3 c, int kind)
// Needs:    nothing
//
// Exposed radiance of the working space in, display light of the working space out (0 to 1 except for linear,
// which is clipped later). The same functions in numpy: tone_curves.py.
const int TONE_NEUTRAL = 0;
const int TONE_CHARACTERISTIC = 1;
const int TONE_LINEAR = 2;
const int TONE_FAITHFUL = 3;

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

vec3 tone_curve(vec3 c, int kind)
{
    c = min(c, vec3(1e6));                              // an infinite radiance must not become a NaN
    if (kind == TONE_NEUTRAL)
        return tone_neutral(c);
    if (kind == TONE_FAITHFUL)
        return tone_faithful(c);
    if (kind == TONE_CHARACTERISTIC)
        return tone_characteristic(c);
    return c;
}
