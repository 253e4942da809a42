// Provides: the share of a pixel that a gap covers, in alpha; no light comes back from it
// Needs:    gap.vert.glsl; blending over what is there
//
// A pixel across the line reaches half a pixel to either side of its own middle.
noperspective in float from_middle;
noperspective in float gap_width;
out vec4 fragment;

void main()
{
    float d = abs(from_middle);
    float covered = min(0.5 * gap_width, d + 0.5) - max(-0.5 * gap_width, d - 0.5);
    fragment = vec4(0.0, 0.0, 0.0, clamp(covered, 0.0, 1.0));
}
