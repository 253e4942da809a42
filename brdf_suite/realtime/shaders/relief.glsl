// Provides: vec3 slopes_at(sampler2D map, vec2 at), vec3 leaning(vec3 n, vec2 slopes, mat2x3 axes, vec3 v),
//           mat2x3 surface_axes(vec3 n, vec3 position, vec2 uv),
//           vec3 normal_map(vec2 uv) with NORMAL_MAP, vec3 orange_peel(vec2 uv) with COAT_RELIEF
// Needs:    a fragment shader (derivatives)
//
// A relief is a map of slopes: red and green dh/du and dh/dv, blue the sum of their squares. Slopes can be averaged,
// so mip levels are right, and what a level has lost is the variance blue - (red^2 + green^2): it widens the lobe
// (Olano and Baker 2010, "LEAN mapping"), and a relief too fine to be seen turns into gloss instead of shimmering.

// Slopes, and the variance that the mip level hides.
vec3 slopes_at(sampler2D map, vec2 at)
{
    vec3 texel = texture(map, at).rgb;
    return vec3(texel.rg, max(texel.b - dot(texel.rg, texel.rg), 0.0));
}

// Unit directions on the surface along which u and v grow (Schueler 2013). Zero where there are no coordinates.
mat2x3 surface_axes(vec3 n, vec3 position, vec2 uv)
{
    vec3 across = cross(dFdy(position), n), down = cross(n, dFdx(position));
    vec2 x = dFdx(uv), y = dFdy(uv);
    vec3 u = across * x.x + down * y.x;
    vec3 v = across * x.y + down * y.y;
    // The products are tiny numbers in float32 (metres times millimetres within a pixel): scaled before squaring.
    float size = max(max(max(abs(u.x), abs(u.y)), abs(u.z)), max(max(abs(v.x), abs(v.y)), abs(v.z)));
    if (size <= 0.0)
        return mat2x3(0.0);
    u /= size;
    v /= size;
    return mat2x3(u * inversesqrt(max(dot(u, u), 1e-12)), v * inversesqrt(max(dot(v, v), 1e-12)));
}

// The normal of a surface with these slopes; one that looks away from the viewer is bent to just above grazing.
vec3 leaning(vec3 n, vec2 slopes, mat2x3 axes, vec3 v)
{
    const float LOWEST = 1e-3;
    vec3 m = normalize(n - slopes.x * axes[0] - slopes.y * axes[1]);
    float cos_theta = dot(m, v);
    return cos_theta >= LOWEST ? m : normalize(m + (LOWEST - cos_theta) * v);
}

#ifdef NORMAL_MAP
uniform sampler2D normal_slopes;
uniform vec2 normal_tiles;       // per millimetre, along u and v
uniform float normal_strength;

// The slopes of the normal map at a place, and their hidden variance.
vec3 normal_map(vec2 uv)
{
    return slopes_at(normal_slopes, uv * normal_tiles) * vec3(vec2(normal_strength), normal_strength * normal_strength);
}
#endif

#ifdef COAT_RELIEF
uniform sampler2D peel_slopes;
uniform float peel_tiles;        // per millimetre
uniform float peel_slope;        // root mean square

// The tile twice, the second time turned and stretched by numbers that do not fit, so that it never repeats.
vec3 orange_peel(vec2 uv)
{
    const mat2 TURN = mat2(0.8090170, 0.5877853, -0.5877853, 0.8090170);    // by 36 degrees
    const float STRETCH = 1.0352762;
    vec3 one = slopes_at(peel_slopes, uv * peel_tiles);
    vec3 other = slopes_at(peel_slopes, TURN * uv * (peel_tiles * STRETCH) + vec2(0.37, 0.61));
    // transpose(TURN) brings slopes along the turned axes back to u and v.
    vec2 sum = (one.xy + other.xy * TURN) * (0.7071068 * peel_slope);
    return vec3(sum, 0.5 * (one.z + other.z) * peel_slope * peel_slope);
}
#endif
