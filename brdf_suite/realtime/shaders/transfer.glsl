// Provides: vec3 srgb_encode(vec3 linear), vec3 device_encode(vec3 linear), vec3 quantize(vec3 encoded, vec2 pixel)
// Needs:    nothing
uniform sampler2D device_codes;  // a row: the codes of the three channels over sRGB-encoded light
uniform int device_steps;        // its length; 0: the device's curve is that of sRGB

// IEC 61966-2-1.
vec3 srgb_encode(vec3 c)
{
    vec3 high = 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

// Codes of the device. A table over encoded light is as fine in the darks as in the lights.
vec3 device_encode(vec3 linear)
{
    vec3 encoded = srgb_encode(linear);
    if (device_steps == 0)
        return encoded;
    vec3 place = clamp(encoded, 0.0, 1.0) * float(device_steps - 1);
    ivec3 low = ivec3(place);
    ivec3 high = min(low + 1, device_steps - 1);
    vec3 below = vec3(texelFetch(device_codes, ivec2(low.r, 0), 0).r, texelFetch(device_codes, ivec2(low.g, 0), 0).g,
                      texelFetch(device_codes, ivec2(low.b, 0), 0).b);
    vec3 above = vec3(texelFetch(device_codes, ivec2(high.r, 0), 0).r, texelFetch(device_codes, ivec2(high.g, 0), 0).g,
                      texelFetch(device_codes, ivec2(high.b, 0), 0).b);
    return mix(below, above, place - vec3(low));
}

// To 8 bits with a dither of half a step either way, so that a smooth flank of paint shows no bands. The noise is
// a fixed function of the pixel (interleaved gradient noise), the same for the three channels and every frame.
vec3 quantize(vec3 encoded, vec2 pixel)
{
    float noise = fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
    return floor(encoded * 255.0 + noise) / 255.0;
}
