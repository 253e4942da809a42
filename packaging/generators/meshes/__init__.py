"""Generators of the packaged meshes."""
