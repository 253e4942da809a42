"""Meshes as arrays: the value, its repair, and generated forms."""
