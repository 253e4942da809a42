// Provides: nothing: the depth alone is kept
// Needs:    shadow_map.vert.glsl
void main()
{
}
