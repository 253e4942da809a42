"""Baked occlusion: the visible fraction of light at each place of a mesh, and its mean direction."""
