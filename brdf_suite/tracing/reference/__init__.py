"""Pictures by the path tracer."""
