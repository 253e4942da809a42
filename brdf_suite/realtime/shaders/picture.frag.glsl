// Provides: a picture as wide as the frame, in its middle, as it is or exposed
//           (AS_LIGHT: its sRGB codes as light of the working space)
// Needs:    screen.vert.glsl; one picture, its lowest row first
//
// The lens is defined by the width of the sensor, so a picture of the same camera fits by its width at any height.
uniform sampler2D picture;
uniform vec2 frame_size;         // pixels
uniform vec2 frame_corner;       // of the frame in the target, pixels
uniform vec4 beyond;             // what is above and below the picture
uniform float gain;              // factor on the picture's colours
#ifdef AS_LIGHT
uniform mat3 to_working;         // from linear sRGB
#endif
out vec4 fragment;

vec3 taken(vec3 colour)
{
#ifdef AS_LIGHT
    // IEC 61966-2-1.
    vec3 curved = pow((colour + 0.055) / 1.055, vec3(2.4));
    return to_working * mix(curved, colour / 12.92, vec3(lessThanEqual(colour, vec3(0.04045))));
#else
    return colour;
#endif
}

void main()
{
    vec2 size = vec2(textureSize(picture, 0));
    vec2 from_middle = (gl_FragCoord.xy - frame_corner - 0.5 * frame_size) / frame_size.x;
    vec2 place = from_middle * vec2(1.0, size.x / size.y) + 0.5;
    bool inside = place.y >= 0.0 && place.y <= 1.0;
    fragment = inside ? vec4(taken(texture(picture, place).rgb) * gain, 1.0) : beyond;
}
