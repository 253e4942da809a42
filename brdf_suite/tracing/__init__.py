"""Jobs of the path tracer and the ray tracer."""
