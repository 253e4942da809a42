// Provides: world_position, world_normal and surface_uv (millimetres) for surface_point.glsl; with OCCLUSION also
//           arriving_light
// Needs:    a mesh in world metres
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

#ifdef OCCLUSION
// xyz: mean direction of the light that arrives, w: share of a uniform light's irradiance; without and with a floor.
in vec4 light_alone;
in vec4 light_grounded;
uniform bool grounded;
out vec4 arriving_light;
#endif

uniform mat4 world_to_clip;

// A second paint is drawn over the first by another program: at the very same depth.
invariant gl_Position;

out vec3 world_position;
out vec3 world_normal;
out vec2 surface_uv;

void main()
{
    world_position = position;
    world_normal = normal;
    surface_uv = uv;
#ifdef OCCLUSION
    arriving_light = grounded ? light_grounded : light_alone;
#endif
    gl_Position = world_to_clip * vec4(position, 1.0);
}
