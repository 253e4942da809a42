"""Meshes as arrays: values, repair, and generated forms."""
