// Provides: field, the place on the ground as a coordinate of ground_shadow
// Needs:    a draw of four vertices as a strip, without attributes
uniform mat4 world_to_clip;
uniform vec4 ground_field;      // lowest x and z, highest x and z, metres
uniform float ground_height;
uniform float ground_beyond;    // metres by which it is drawn larger on each side

out vec2 field;
out vec3 ground_position;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 xz = mix(ground_field.xy - ground_beyond, ground_field.zw + ground_beyond, corner);
    field = (xz - ground_field.xy) / (ground_field.zw - ground_field.xy);
    ground_position = vec3(xz.x, ground_height, xz.y);
    gl_Position = world_to_clip * vec4(ground_position, 1.0);
}
