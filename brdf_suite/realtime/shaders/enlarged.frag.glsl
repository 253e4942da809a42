// Provides: a picture drawn out over the frame
// Needs:    screen.vert.glsl
//
// Along each axis by itself: a rounded size has another shape, and picture.frag.glsl would leave an edge beside it.
uniform sampler2D picture;
uniform vec2 size;               // of the frame, pixels
out vec4 fragment;

void main()
{
    fragment = texture(picture, gl_FragCoord.xy / size);
}
