// Provides: vec3 reflected_radiance(SurfacePoint p): the sum of lobes.glsl over look-ups that were made before
// Needs:    ramp.glsl, captured.glsl, environment.glsl; BROAD, SHARP, FOR_EACH_SHARP_LOBE as lobes.glsl; a texture that kept_light.py made
//
// Where a lobe is looked up, and through which exponent, is the same for every paint; only the weights of the ramp differ.
// So what each look-up gives at each captured place is kept, a list below the other, and a paint weighs it. In alpha is
// the place's coordinate in the ramp.
uniform sampler2D kept_light;
uniform int kept_layers[1 + MAX_SHARP + MAX_BROAD];    // which list, for each row of the ramp
uniform float kept_scale;                               // what the lists were divided by

vec4 kept_at(int row)
{
    ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, first_row);
    return texelFetch(kept_light, ivec2(at.x, at.y + kept_layers[row] * place_rows), 0);
}

vec3 reflected_radiance(SurfacePoint p)
{
    vec4 light = kept_at(0);
    float x = light.a;
    vec3 radiance = ramp_row(x, 0).rgb * light.rgb;
#if BROAD > 0
    for (int k = 0; k < BROAD; ++k)
#else
    for (int k = 0; k < look_ups.y; ++k)
#endif
        radiance += ramp_row(x, 1 + MAX_SHARP + k).rgb * kept_at(1 + MAX_SHARP + k).rgb;
#define ADD_SHARP_LOBE(k) radiance += ramp_row(x, 1 + k).rgb * kept_at(1 + k).rgb;
    FOR_EACH_SHARP_LOBE(ADD_SHARP_LOBE)
    return light_colour * (radiance * kept_scale);
}
