// Provides: struct FlakePlace, FlakePlace flake_place(SurfacePoint p), mat3 local_frame(vec3 n)
// Needs:    surface_point.glsl; a fragment shader (derivatives); uniform bool has_uv
//
// Where the pixel is on the surface in millimetres, and how that changes from pixel to pixel. Surfaces without texture
// coordinates are projected along the axis that the normal is nearest to: flakes then hang in space as well, but
// slanted parts are stretched, by up to a factor of sqrt(3) along one axis.
uniform bool has_uv;

struct FlakePlace
{
    vec2 at;             // mm
    vec2 across, down;   // mm per pixel
};

FlakePlace flake_place(SurfacePoint p)
{
#ifdef CAPTURED
    return FlakePlace(p.place, p.place_across, p.place_down);
#else
    vec3 across = 1e3 * dFdx(p.position), down = 1e3 * dFdy(p.position);
    if (has_uv)
        return FlakePlace(p.uv, dFdx(p.uv), dFdy(p.uv));
    vec3 size = abs(p.normal);
    vec3 place = 1e3 * p.position;
    if (size.x >= size.y && size.x >= size.z)
        return FlakePlace(place.zy, across.zy, down.zy);
    if (size.y >= size.z)
        return FlakePlace(place.xz + 4096.0, across.xz, down.xz);
    return FlakePlace(place.xy - 4096.0, across.xy, down.xy);
#endif
}

// Rows: two tangents and the normal, without a square root or a branch (Duff et al., JCGT 6(1), 2017). It stands still
// on the object, so that a flake keeps its tilt; where it jumps, at n.z = 0, other flakes begin.
mat3 local_frame(vec3 n)
{
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * n.y * a;
    return transpose(mat3(vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x),
                          vec3(b, side + n.y * n.y * a, -n.y), n));
}
