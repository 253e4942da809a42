"""Baked occlusion: how much of the light each place of a mesh sees, and from which side it comes."""
