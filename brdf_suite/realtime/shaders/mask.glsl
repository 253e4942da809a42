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
    vec2 at = p.uv * mask_tiles + vec2(dot(mask_u, place), dot(mask_v, place));
    if (mask_tiles.x == 0.0)
    {
        // Laid over the box once: its edges do not run on at the other side.
        vec2 inside = 0.5 / vec2(textureSize(paint_mask, 0));
        at = clamp(at, inside, 1.0 - inside);
    }
    return texture(paint_mask, at).r;
}
