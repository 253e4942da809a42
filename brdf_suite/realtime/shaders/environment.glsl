// Provides: uniforms diffuse_map, diffuse_scale, background_map, background_scale, light_turn, light_colour;
//           vec3 to_environment(vec3 world), vec3 background_radiance(vec3 world)
// Needs:    nothing
//
// World directions are right-handed, y up. The light is turned about y by an angle, counter-clockwise seen from
// above; a direction of the world is looked up in the map after the inverse turn. light_turn = (cos, sin).
// light_colour is the environment's colour under another lamp: a matrix on what its maps make the surface reflect,
// once, and on the background; appearance/light/matrix.py. Maps hold radiance / scale in half floats, in the order and orientation of OpenGL's cube maps.
uniform samplerCube diffuse_map;
uniform float diffuse_scale;
uniform samplerCube background_map;
uniform float background_scale;
uniform vec2 light_turn;
uniform mat3 light_colour;

vec3 to_environment(vec3 world)
{
    return vec3(light_turn.x * world.x - light_turn.y * world.z,
                world.y,
                light_turn.y * world.x + light_turn.x * world.z);
}

vec3 background_radiance(vec3 world)
{
    return light_colour * (texture(background_map, to_environment(world)).rgb * background_scale);
}
