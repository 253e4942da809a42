// Provides: a picture of half the size, by weights of 1, 3, 3, 1 along each axis; past its edges is no light
// Needs:    screen.vert.glsl
uniform sampler2D finer;
out vec4 fragment;

void main()
{
    ivec2 size = textureSize(finer, 0);
    ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 1;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < 16; ++k)
    {
        ivec2 step = ivec2(k & 3, k >> 2);
        ivec2 at = first + step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size)))
            continue;
        vec2 weight = vec2(step.x == 0 || step.x == 3 ? 1.0 : 3.0, step.y == 0 || step.y == 3 ? 1.0 : 3.0);
        sum += weight.x * weight.y * texelFetch(finer, at, 0).rgb;
    }
    fragment = vec4(sum * (1.0 / 64.0), 0.0);
}
