// Provides: SurfacePoint surface_point(vec3 eye) of a captured place
// Needs:    the struct of surface_point.glsl; screen.vert.glsl; a list that capture.frag.glsl made
//
// A place is eight texels of `places`, one below the other, `place_rows` apart; their order is capture.frag.glsl's.
uniform sampler2D places;
uniform int place_rows;          // rows of the list
uniform int first_row;           // of the target, where this paint's list begins

SurfacePoint surface_point(vec3 eye)
{
    ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, first_row);
    vec4 kept[8];
    for (int i = 0; i < 8; ++i)
        kept[i] = texelFetch(places, ivec2(at.x, at.y + i * place_rows), 0);
    SurfacePoint p;
    p.position = kept[0].xyz;
    p.view = normalize(eye - p.position);
    p.normal = kept[1].xyz;
    p.coat_normal = p.normal;
    p.bent = kept[2].xyz;
    p.occlusion = kept[2].w;
    p.base_spread = 0.0;
    p.coat_spread = 0.0;
    p.normal_across = kept[3].xyz;
    p.normal_down = kept[4].xyz;
    p.mirror_across = kept[5].xyz;
    p.mirror_down = kept[6].xyz;
    p.place = vec2(kept[1].w, kept[3].w);
    p.place_across = vec2(kept[4].w, kept[5].w);
    p.place_down = vec2(kept[6].w, kept[7].x);
    p.uv = p.place;
    return p;
}
