// Provides: the finished picture: each sample through tone curve and primaries, averaged in the screen's linear
//           light, encoded, marked, dithered to 8 bits; or the averaged radiance itself
// Needs:    screen.vert.glsl; SAMPLES; GLARE where light above white is spread (glare.py)
#include "samples.glsl"
#include "display.glsl"
#include "transfer.glsl"

uniform vec4 frame;              // xy: this tile's corner in the whole picture
uniform float exposure;
uniform bool as_radiance;        // radiance of the working space and the object's share of the pixel, no more
uniform bool dithered;           // to 8 bits; otherwise exact
#ifdef GLARE
uniform sampler2D glare;         // what is spread over the whole picture
uniform vec2 glare_size;         // of what it covers, pixels
uniform float glare_share;       // of the light above white, that is taken from where it is
uniform float glare_white;
vec3 veil;

vec4 seen_sample(int i)
{
    vec4 own = light_sample(i);
    return vec4(own.rgb - glare_share * max(own.rgb - glare_white, 0.0) + veil, own.a);
}
#else
#define seen_sample light_sample
#endif
uniform bool transparent;        // the object's share of the pixel as alpha, the colour that of the object alone
out vec4 fragment;

// Of a transparent picture, the light of the object alone: samples hold its share of it, which edges in depth of field
// and panes make any number.
vec3 own_light(vec4 seen)
{
    return transparent ? seen.rgb / max(seen.a, 1e-4) : seen.rgb;
}

void main()
{
#ifdef GLARE
    veil = texture(glare, (gl_FragCoord.xy + frame.xy) / glare_size).rgb;
#endif
    vec4 first = seen_sample(0);
    vec4 sum = first;
    bool even = true;
    for (int i = 1; i < SAMPLE_COUNT; ++i)
    {
        vec4 other = seen_sample(i);
        even = even && other == first;
        sum += other;
    }
    if (as_radiance)
    {
        fragment = vec4(sum.rgb / exposure, sum.a) / float(SAMPLE_COUNT);
        return;
    }
    // Where all samples are one, inside a triangle, the curve is taken once.
    vec3 device = device_light(own_light(first));
    vec2 beyond = beyond_device(device);
    vec3 shown = clamp(device, 0.0, 1.0);
    if (!even)
    {
        float weight = transparent ? first.a : 1.0;
        shown *= weight;
        for (int i = 1; i < SAMPLE_COUNT; ++i)
        {
            vec4 other = seen_sample(i);
            device = device_light(own_light(other));
            beyond = max(beyond, beyond_device(device));
            float share = transparent ? other.a : 1.0;
            shown += share * clamp(device, 0.0, 1.0);
            weight += share;
        }
        shown /= max(weight, 1e-4);
    }
    float alpha = transparent ? sum.a / float(SAMPLE_COUNT) : 1.0;
    vec2 pixel = gl_FragCoord.xy + frame.xy;
    vec3 encoded = marked(device_encode(shown), beyond, pixel);
    fragment = vec4(dithered ? quantize(encoded, pixel) : encoded, alpha);
}
