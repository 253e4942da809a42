// Provides: vec3 srgb_encode(vec3 linear), vec3 device_encode(vec3 linear), vec3 quantize(vec3 encoded, vec2 pixel)
// Needs:    nothing
uniform sampler2D device_codes;  // a row: the codes of the three channels over sRGB-encoded light; or a table of cells
uniform int device_steps;        // the row's length; 0: the device's curve is that of sRGB
uniform int device_cells;        // points of the table on each axis, red in columns, blue within green in rows; 0: none

// IEC 61966-2-1.
vec3 srgb_encode(vec3 c)
{
    vec3 high = 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

vec3 table_codes(ivec3 cell)
{
    return texelFetch(device_codes, ivec2(cell.r, cell.g * device_cells + cell.b), 0).rgb;
}

// Tetrahedral: from the lowest corner along the axis of the largest remainder, to the highest along that of the least.
vec3 interpolate_table(vec3 encoded)
{
    vec3 place = clamp(encoded, 0.0, 1.0) * float(device_cells - 1);
    ivec3 low = min(ivec3(place), device_cells - 2);
    vec3 part = place - vec3(low);
    ivec3 first = part.r >= part.g ? (part.r >= part.b ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                   : (part.g >= part.b ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    ivec3 last = part.r < part.g ? (part.r < part.b ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                 : (part.g < part.b ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    float most = max(part.r, max(part.g, part.b));
    float least = min(part.r, min(part.g, part.b));
    float middle = part.r + part.g + part.b - most - least;
    return (1.0 - most) * table_codes(low) + (most - middle) * table_codes(low + first)
           + (middle - least) * table_codes(low + 1 - last) + least * table_codes(low + 1);
}

// Codes of the device. A table over encoded light is as fine in the darks as in the lights.
vec3 device_encode(vec3 linear)
{
    vec3 encoded = srgb_encode(linear);
    if (device_cells > 0)
        return interpolate_table(encoded);
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
