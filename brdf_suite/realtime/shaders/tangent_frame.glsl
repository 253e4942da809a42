// Provides: mat3 tangent_frame(SurfacePoint p), whose rows are tangent, bitangent and normal at a place
// Needs:    surface_point.glsl, local_frame of flake_place.glsl; HAS_UV, and TANGENT_MAP where a map turns the tangent
//
// The tangent is the way along which u grows (convention of the local frame: x = tangent, z = normal, right-handed).
// Where a surface has no texture coordinates, any tangent does that stands still on it.
#ifdef TANGENT_MAP
uniform sampler2D tangent_turns;             // cosine and sine of the angle from the way of u towards that of v
uniform vec2 tangent_tiles;                  // per millimetre, along u and v
#endif

mat3 tangent_frame(SurfacePoint p)
{
#if defined(HAS_UV) && !defined(CAPTURED)
    // Schueler 2013, for u alone. It is across the normal; where u stands still it is nothing, and so are the places.
    vec3 t = cross(dFdy(world_position), p.normal) * dFdx(surface_uv.x)
        + cross(p.normal, dFdx(world_position)) * dFdy(surface_uv.x);
    t *= inversesqrt(max(dot(t, t), 1e-36));
#ifdef TANGENT_MAP
    vec2 turn = texture(tangent_turns, p.uv * tangent_tiles).rg;
    t = normalize(turn.x * t + turn.y * cross(p.normal, t) + 1e-6 * t);
#endif
    return transpose(mat3(t, cross(p.normal, t), p.normal));
#else
    return local_frame(p.normal);
#endif
}
