// Provides: a picture drawn out over the frame
// Needs:    screen.vert.glsl
uniform sampler2D picture;
uniform vec2 size;               // of the frame, pixels
out vec4 fragment;

void main()
{
    fragment = texture(picture, gl_FragCoord.xy / size);
}
