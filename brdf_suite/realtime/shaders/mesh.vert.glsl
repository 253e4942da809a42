// Provides: world_position, world_normal and surface_uv (millimetres) for surface_point.glsl; with OCCLUSION also
//           arriving_light, with TWO_SIDED arriving_behind
// Needs:    a mesh in world metres; TWO_SIDED where the light that arrives is known for the back too
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

#ifdef OCCLUSION
// xyz: mean direction of the light that arrives, w: share of a uniform light's irradiance; without and with a floor.
in vec4 light_alone;
in vec4 light_grounded;
uniform bool grounded;
out vec4 arriving_light;
#ifdef TWO_SIDED
// The same for the back.
in vec4 back_alone;
in vec4 back_grounded;
out vec4 arriving_behind;
#endif
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
#ifdef TWO_SIDED
    arriving_behind = grounded ? back_grounded : back_alone;
#endif
#endif
    gl_Position = world_to_clip * vec4(position, 1.0);
}
