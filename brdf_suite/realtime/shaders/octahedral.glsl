// Provides: vec2 to_square(vec3 direction), vec3 from_square(vec2 place)
// Needs:    nothing
//
// The octahedral map, y up: a direction of any length but 0 -> a place in [-1, 1]^2.
vec2 to_square(vec3 d)
{
    vec2 p = d.xz / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 folded = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0) * (1.0 - abs(p.yx));
    return d.y < 0.0 ? folded : p;
}

vec3 from_square(vec2 p)
{
    float y = 1.0 - abs(p.x) - abs(p.y);
    vec2 folded = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0) * (1.0 - abs(p.yx));
    vec2 inside = y < 0.0 ? folded : p;
    return normalize(vec3(inside.x, y, inside.y));
}
