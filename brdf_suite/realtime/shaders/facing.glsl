// Provides: vec3 facing_normal(vec3 shading_normal, vec3 position, vec3 v)
// Needs:    a fragment shader (derivatives)
//
// The unit shading normal, turned to the side that is seen. Which side that is, is decided by the plane of the
// triangle itself, not by its winding: thin sheets are seen from both sides, and foreign meshes mix windings.
// An interpolated normal that still looks away, as happens at a silhouette, is bent to just above grazing.
vec3 facing_normal(vec3 shading_normal, vec3 position, vec3 v)
{
    const float LOWEST = 1e-3;
    vec3 plane = cross(dFdx(position), dFdy(position));
    plane *= sign(dot(plane, v));
    vec3 n = shading_normal * inversesqrt(max(dot(shading_normal, shading_normal), 1e-12));
    n *= dot(n, plane) < 0.0 ? -1.0 : 1.0;
    float cos_theta = dot(n, v);
    return cos_theta >= LOWEST ? n : normalize(n + (LOWEST - cos_theta) * v);
}
