// Provides: vec3 srgb_encode(vec3 linear), vec3 quantize(vec3 encoded, vec2 pixel)
// Needs:    nothing

// IEC 61966-2-1.
vec3 srgb_encode(vec3 c)
{
    vec3 high = 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

// To 8 bits with a dither of half a step either way, so that a smooth flank of paint shows no bands. The noise is
// a fixed function of the pixel (interleaved gradient noise), the same for the three channels and every frame.
vec3 quantize(vec3 encoded, vec2 pixel)
{
    float noise = fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
    return floor(encoded * 255.0 + noise) / 255.0;
}
