// Provides: float mask_share(SurfacePoint p), the share of the second paint at a place, 0 to 1
// Needs:    surface_point.glsl
uniform sampler2D paint_mask;
// The coordinate is uv times the tiles, or where these are 0 a place in the object's box.
uniform vec2 mask_tiles;
uniform vec4 mask_u;
uniform vec4 mask_v;

float mask_share(SurfacePoint p)
{
    vec4 place = vec4(p.position, 1.0);
    return texture(paint_mask, p.uv * mask_tiles + vec2(dot(mask_u, place), dot(mask_v, place))).r;
}
