// Provides: SurfacePoint surface_point(vec3 eye) of a ball that fills the picture, seen from infinitely far away
// Needs:    the struct of surface_point.glsl; screen.vert.glsl
//
// A reflectance ball: each pixel is a normal, seen along one direction, at one place. Past the ball's edge it is the edge.
uniform mat3 ball_axes;          // of the view in the world: right, up, backward
uniform vec3 ball_place;         // of the ball, metres
uniform float ball_pixels;       // along an edge of the picture

SurfacePoint surface_point(vec3 eye)
{
    vec2 at = (2.0 * gl_FragCoord.xy / ball_pixels - 1.0) / BALL_SHARE;
    float outside = max(length(at), 1e-6);
    at *= min(1.0, 0.9999 / outside);
    SurfacePoint p;
    p.position = ball_place;
    p.view = ball_axes[2];
    p.normal = ball_axes * vec3(at, sqrt(1.0 - dot(at, at)));
    p.coat_normal = p.normal;
    p.uv = vec2(0.0);
    p.bent = p.normal;
    p.occlusion = 1.0;
    p.base_spread = 0.0;
    p.coat_spread = 0.0;
    return p;
}
