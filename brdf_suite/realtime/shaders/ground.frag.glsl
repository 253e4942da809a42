// Provides: the shadow on the ground: what is left of the light there, to be multiplied onto the background
// Needs:    ground.vert.glsl; blending of destination times source
uniform sampler2D ground_shadow;

in vec2 field;
out vec4 fragment;

void main()
{
    // The object's coverage in alpha is not the ground's matter.
    fragment = vec4(texture(ground_shadow, field).rgb, 1.0);
}
