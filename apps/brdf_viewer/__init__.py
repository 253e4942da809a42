"""Viewer: the surface in its paint, in an environment, as the painter's customer will see it."""
