// Provides: a picture as wide as the frame, in its middle, as it is or exposed
// Needs:    screen.vert.glsl; one picture, its lowest row first
//
// The lens is told by the width of the sensor, so a picture of the same camera fits by its width at any height.
uniform sampler2D picture;
uniform vec2 frame_size;         // pixels
uniform vec2 frame_corner;       // of the frame in the target, pixels
uniform vec4 beyond;             // what is above and below the picture
uniform float gain;              // factor on the picture's colours
out vec4 fragment;

void main()
{
    vec2 size = vec2(textureSize(picture, 0));
    vec2 from_middle = (gl_FragCoord.xy - frame_corner - 0.5 * frame_size) / frame_size.x;
    vec2 place = from_middle * vec2(1.0, size.x / size.y) + 0.5;
    bool inside = place.y >= 0.0 && place.y <= 1.0;
    fragment = inside ? vec4(texture(picture, place).rgb * gain, 1.0) : beyond;
}
