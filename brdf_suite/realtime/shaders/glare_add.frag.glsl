// Provides: a share of a picture, blurred by weights of 1, 2, 1 along each axis, and the one of half its size drawn out
//           over it
// Needs:    screen.vert.glsl
//
// Past the edges is no light.
uniform sampler2D own;
uniform sampler2D coarser;
uniform float share;
uniform bool has_coarser;
out vec4 fragment;

vec3 fetched(sampler2D picture, ivec2 at)
{
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, textureSize(picture, 0))))
        return vec3(0.0);
    return texelFetch(picture, at, 0).rgb;
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    int places = share > 0.0 ? 9 : 0;
    for (int k = 0; k < places; ++k)
    {
        ivec2 step = ivec2(k % 3, k / 3) - 1;
        sum += (0.0625 * share * float((2 - abs(step.x)) * (2 - abs(step.y)))) * fetched(own, at + step);
    }
    if (has_coarser)
    {
        // The nearest four: three quarters of the one that this lies in, along each axis, and a quarter of the next.
        ivec2 near = at / 2;
        ivec2 next = near + 2 * (at & 1) - 1;
        sum += 0.5625 * fetched(coarser, near) + 0.1875 * (fetched(coarser, ivec2(next.x, near.y)) + fetched(coarser, ivec2(near.x, next.y)))
            + 0.0625 * fetched(coarser, next);
    }
    fragment = vec4(sum, 0.0);
}
