// Provides: uniform block Lights (one buffer), struct Arriving, Arriving light_at(int index, vec3 position),
//           MOST_LIGHTS, LIGHT_OF_ENVIRONMENT
// Needs:    nothing. Written by lights/block.py
//
// The environment's lights come first: their light is in the prefiltered maps already, and only what single flakes
// make of it is added. Lamps follow; theirs is not, and all of it is added.
const int MOST_LIGHTS = 24;
const float LIGHT_OF_ENVIRONMENT = 0.0;
const float LIGHT_DIRECTIONAL = 1.0;
const float LIGHT_POINT = 2.0;

layout(std140) uniform Lights
{
    vec4 light_counts;               // x: of the environment, y: all
    vec4 lights[2 * MOST_LIGHTS];    // of 2 k: direction to the light, or its place in metres; w: kind
                                     // of 2 k + 1: rgb: irradiance on what faces it, at 1 m from a point; w: its
                                     // standard deviation in angle along an axis, radians, at 1 m from a point
};

struct Arriving
{
    vec3 direction;                  // unit, to the light
    vec3 irradiance;                 // on what faces it
    float spread;                    // radians
};

Arriving light_at(int index, vec3 position)
{
    vec4 place = lights[2 * index];
    vec4 power = lights[2 * index + 1];
    if (place.w != LIGHT_POINT)
        return Arriving(place.xyz, power.rgb, power.w);
    vec3 way = place.xyz - position;
    float squared = max(dot(way, way), 1e-8);
    float nearness = inversesqrt(squared);
    return Arriving(way * nearness, power.rgb / squared, power.w * nearness);
}
