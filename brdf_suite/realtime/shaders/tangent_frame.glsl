// Provides: mat3 tangent_frame(SurfacePoint p), whose rows are tangent, bitangent and normal at a place
// Needs:    surface_point.glsl, local_frame of flake_place.glsl; TANGENT_MAP where a map turns the tangent
//
// The tangent is the way along which u grows (convention of the local frame: x = tangent, z = normal, right-handed).
// Where a surface has no texture coordinates, any tangent does that stands still on it.
#ifdef TANGENT_MAP
uniform sampler2D tangent_turns;             // cosine and sine of the angle from the way of u towards that of v
uniform vec2 tangent_tiles;                  // per millimetre, along u and v
#endif

mat3 tangent_frame(SurfacePoint p)
{
    mat3 anyhow = local_frame(p.normal);
#ifdef CAPTURED
    return anyhow;
#else
    vec3 along = surface_axes(p.normal, world_position, surface_uv)[0];
    along -= dot(along, p.normal) * p.normal;
    float size = dot(along, along);
    if (size < 1e-8)
        return anyhow;
    vec3 t = along * inversesqrt(size);
    vec3 b = cross(p.normal, t);
#ifdef TANGENT_MAP
    vec2 turn = texture(tangent_turns, p.uv * tangent_tiles).rg;
    turn = dot(turn, turn) > 1e-8 ? normalize(turn) : vec2(1.0, 0.0);
    t = turn.x * t + turn.y * b;
    b = cross(p.normal, t);
#endif
    return transpose(mat3(t, b, p.normal));
#endif
}
