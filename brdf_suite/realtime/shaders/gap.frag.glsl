// Provides: the share of a pixel that a gap covers, in alpha; no light comes back from it
// Needs:    gap.vert.glsl; blending over what is there
//
// Pixels beside each other share the gap out among them: across the line each reaches as far as to the next one's.
noperspective in float from_middle;
noperspective in float gap_width;
noperspective in float reach;
out vec4 fragment;

void main()
{
    float d = abs(from_middle);
    float covered = min(0.5 * gap_width, d + 0.5 * reach) - max(-0.5 * gap_width, d - 0.5 * reach);
    if (covered <= 0.0)
        discard;
    fragment = vec4(0.0, 0.0, 0.0, clamp(covered / reach, 0.0, 1.0));
}
