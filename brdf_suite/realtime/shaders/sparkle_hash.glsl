// Provides: uint scrambled(uint x), uvec4 scrambled(uvec4 x), uint cell_key(ivec2 cell, uint salt), vec2 halves(uint word)
// Needs:    nothing
//
// Integers only, so that every machine, and the same functions in numpy (tools/evaluation/flake_model.py), agree to the
// last bit: a flake has to be the same flake in every frame, tile and program.

// A bijection of 32 bits in which each bit in changes each bit out with a chance near one half (two rounds of
// multiplication and shift; the constants are those of Chris Wellons's search, bias 0.107).
uint scrambled(uint x)
{
    x = (x ^ (x >> 16)) * 0x21f0aaadu;
    x = (x ^ (x >> 15)) * 0xd35a2d97u;
    return x ^ (x >> 15);
}

uvec4 scrambled(uvec4 x)
{
    x = (x ^ (x >> 16u)) * 0x21f0aaadu;
    x = (x ^ (x >> 15u)) * 0xd35a2d97u;
    return x ^ (x >> 15u);
}

uint cell_key(ivec2 cell, uint salt)
{
    return scrambled(uint(cell.x) + scrambled(uint(cell.y) + salt));
}

// Two numbers of 16 bits in (0, 1), even.
vec2 halves(uint word)
{
    return (vec2(float(word & 0xffffu), float(word >> 16)) + 0.5) * (1.0 / 65536.0);
}
