// Provides: f_r of a model that a user wrote, for a pair of directions a pixel; drawn without a mesh.
// Needs: BRDF(L, V, N, X, Y) and its uniforms, which take the place of the line MODEL.
uniform sampler2D brdf_suite_light;
uniform sampler2D brdf_suite_view;
out vec4 brdf_suite_value;
MODEL
void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec3 light = texelFetch(brdf_suite_light, place, 0).xyz;
    vec3 view = texelFetch(brdf_suite_view, place, 0).xyz;
    vec3 normal = vec3(0.0, 0.0, 1.0), x = vec3(1.0, 0.0, 0.0), y = vec3(0.0, 1.0, 0.0);
    brdf_suite_value = vec4(BRDF(light, view, normal, x, y), 1.0);
}
