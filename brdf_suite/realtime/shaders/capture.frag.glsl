// Provides: all that shading asks of a place but the paint, as eight colours (captured.glsl reads them)
// Needs:    what mesh.vert.glsl hands on; several render targets of whole floats
uniform vec3 eye;
uniform float kept;              // 1: a place of the paint, 2: of something else, which is drawn as it is

#include "surface_point.glsl"
#include "environment.glsl"
#include "flake_place.glsl"

layout(location = 0) out vec4 position_kind;
layout(location = 1) out vec4 normal_place;
layout(location = 2) out vec4 arriving;
layout(location = 3) out vec4 normal_across;
layout(location = 4) out vec4 normal_down;
layout(location = 5) out vec4 mirror_across;
layout(location = 6) out vec4 mirror_down;
layout(location = 7) out vec4 last;

void main()
{
    SurfacePoint p = surface_point(eye);
    FlakePlace place = flake_place(p);
    vec3 r = to_environment(2.0 * dot(p.normal, p.view) * p.normal - p.view);
    position_kind = vec4(p.position, kept);
    normal_place = vec4(p.normal, place.at.x);
    arriving = vec4(p.bent, p.occlusion);
    normal_across = vec4(dFdx(p.normal), place.at.y);
    normal_down = vec4(dFdy(p.normal), place.across.x);
    mirror_across = vec4(dFdx(r), place.across.y);
    mirror_down = vec4(dFdy(r), place.down.x);
    last = vec4(place.down.y, 0.0, 0.0, 0.0);
}
