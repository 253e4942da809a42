// Provides: vec4 light_lobe(float part, float chord), vec3 light_diffuse(), vec3 flake_lobe(float chord),
//           DiscLobe disc_lobe(float radius), LOBE_BASE, LOBE_GLOSS, LOBE_FLAKES
// Needs:    LIGHT_LOBE_COLUMNS. Written by lights/block.py
//
// A material's lobes as functions of the angle between the mirror direction of a light and the eye, tabulated, so that
// a light costs one look-up for all of them:
//     base   sum KDD_i cos(gamma)^E_i      gloss   sum KG_i cos(gamma)^E_i      flakes   the visible flakes' share of
// the base, over the bell of their tilts. The table's variable is sqrt(sin(gamma / 2)), which gives the narrow lobes about gamma = 0 most of it; it
// ends at 90 degrees, where every lobe is 0. The alphas of these rows are KD's red, green and blue. A fourth row has
// what the gloss is multiplied by in the light of a disc, and in alpha the gloss's width.
uniform sampler2D light_lobes;

const float LOBE_BASE = 0.0;
const float LOBE_GLOSS = 1.0;
const float LOBE_FLAKES = 2.0;
const float LOBE_DISCS = 3.0;

// chord: the length of the difference of the two unit vectors, 2 sin(gamma / 2).
vec4 light_lobe(float part, float chord)
{
    float along = min(1.1892071 * sqrt(0.5 * chord), 1.0);        // 1 / sqrt(sin(45 degrees))
    const float columns = float(LIGHT_LOBE_COLUMNS);
    return textureLod(light_lobes, vec2((along * (columns - 1.0) + 0.5) / columns, (part + 0.5) / 4.0), 0.0);
}

// The gloss in the light of a disc: even up to `middle`, then the lobe, `stretch` times as broad, times `share`.
struct DiscLobe
{
    float middle, stretch;
    vec3 share;
};

// radius: of the disc, radians. disc_lobe of block.py has the reasons.
DiscLobe disc_lobe(float radius)
{
    vec4 found = light_lobe(LOBE_DISCS, radius);
    float twice = 2.0 * found.a;
    return DiscLobe(max(radius - twice, 0.0),
                    radius < twice ? sqrt(1.0 + radius * radius / (twice * twice)) : 1.7 - 0.29 * twice / radius,
                    found.rgb);
}

// KD, in 1/sr.
vec3 light_diffuse()
{
    return vec3(light_lobe(LOBE_BASE, 2.0).a, light_lobe(LOBE_GLOSS, 2.0).a, light_lobe(LOBE_FLAKES, 2.0).a);
}

// The nearest column of the flakes' row: a hundredth of their brightness cannot be seen, and it is cheaper.
vec3 flake_lobe(float chord)
{
    float along = min(1.1892071 * sqrt(0.5 * chord), 1.0);
    return texelFetch(light_lobes, ivec2(int(along * float(LIGHT_LOBE_COLUMNS - 1) + 0.5), 2), 0).rgb;
}
