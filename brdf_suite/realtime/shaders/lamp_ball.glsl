// Provides: vec3 ball_radiance(SurfacePoint p): what lamps make the surface reflect, read from a reflectance ball
// Needs:    surface_point.glsl, BALL_SHARE; a picture that factors/ball.py drew
//
// The picture of a ball of the material in the lamps' light is a map over the normal: right for lamps far away, for a
// view from far away, and for what looks alike however it is turned about its normal. One look-up then represents all
// lamps (McCool, Ang and Ahmad 2001, section 5).
uniform sampler2D lamp_ball;
uniform mat3 ball_axes;          // of the view in the world: right, up, backward

vec3 ball_radiance(SurfacePoint p)
{
    vec2 at = vec2(dot(p.normal, ball_axes[0]), dot(p.normal, ball_axes[1]));
    // In perspective a normal may look away from the axis and still be seen: it is then at the edge.
    if (dot(p.normal, ball_axes[2]) < 0.0)
        at *= inversesqrt(max(dot(at, at), 1e-12));
    return texture(lamp_ball, 0.5 + 0.5 * BALL_SHARE * at).rgb;
}
