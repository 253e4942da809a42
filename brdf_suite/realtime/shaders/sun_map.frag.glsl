// Provides: nothing: the depth alone is kept
// Needs:    sun_map.vert.glsl
void main()
{
}
