"""The scene in the path tracer: place, relief, ground, background."""
