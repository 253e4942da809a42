// Provides: the samples of each pixel side by side, so that they can be read back
// Needs:    screen.vert.glsl; SAMPLES (0 or 1: a plain texture)
#if SAMPLES > 1
const int COUNT = SAMPLES;
uniform sampler2DMS packed_samples;
#else
const int COUNT = 1;
uniform sampler2D packed_samples;
#endif
out vec4 fragment;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    fragment = texelFetch(packed_samples, ivec2(at.x / COUNT, at.y), at.x % COUNT);
}
