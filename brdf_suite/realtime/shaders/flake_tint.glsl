// Provides: vec3 flake_tint(uint word, float colour_spread)
// Needs:    nothing
//
// A colour of mean 1 over all flakes; the three channels a third of a turn apart.
vec3 flake_tint(uint word, float colour_spread)
{
    float turn = 6.2831853 * (float(word >> 16) + 0.5) * (1.0 / 65536.0);
    return 1.0 + colour_spread * cos(turn + vec3(0.0, 2.0943951, 4.1887902));
}
