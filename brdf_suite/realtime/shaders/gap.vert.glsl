// Provides: from_middle, gap_width and reach for gap.frag.glsl: a strip along a gap, wide enough on the screen to be drawn
// Needs:    a mesh in world metres with, at each point, the direction across the gap
//
// A gap narrower than a pixel is missed by some samples and hit by others, so that its line breaks into dots. Its strip
// is therefore drawn as wide as the gap and a pixel more, in the plane of the surface, and how much of each pixel the
// gap covers follows from the distance to its middle.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
in vec4 across;                  // xyz: unit direction across the gap, w: place on it, mm from the middle

uniform mat4 world_to_clip;
uniform vec3 eye;
uniform vec2 half_size;          // of the target, pixels
uniform float half_gap;          // metres

noperspective out float from_middle;  // pixels
noperspective out float gap_width;    // pixels
noperspective out float reach;        // pixels that a pixel reaches across the line

const float BEYOND = 1.25;       // pixels past the edge of the gap: whole pixels that it reaches into are drawn
const float WIDEST = 16.0;       // times the gap: the surface bends beyond
const float LIFT = 0.002;        // metres towards the eye, past the rounded edges of the panels

// How a place moves on the screen, pixels a metre, when the point at `clip` moves along a direction.
vec2 moved(vec4 clip, vec3 direction)
{
    vec4 d = world_to_clip * vec4(direction, 0.0);
    return (d.xy * clip.w - clip.xy * d.w) / (clip.w * clip.w) * half_size;
}

void main()
{
    float place = across.w * 1e-3;
    vec3 middle = position - across.xyz * place;
    vec4 clip = world_to_clip * vec4(middle, 1.0);
    vec2 aside = moved(clip, across.xyz);
    vec3 lengthwise = cross(normal, across.xyz);
    vec2 along = moved(clip, lengthwise / max(length(lengthwise), 1e-9));
    // Pixels a metre across the line as it is seen.
    float scale = abs(aside.x * along.y - aside.y * along.x) / max(length(along), 1e-6);
    reach = max(abs(along.x), abs(along.y)) / max(length(along), 1e-6);
    float drawn = min(half_gap + BEYOND / max(scale, 1e-6), WIDEST * half_gap);
    float share = place / half_gap;
    gap_width = 2.0 * half_gap * scale;
    from_middle = share * drawn * scale;
    vec3 world = middle + across.xyz * (share * drawn);
    world += LIFT * normalize(eye - world);
    gl_Position = world_to_clip * vec4(world, 1.0);
}
