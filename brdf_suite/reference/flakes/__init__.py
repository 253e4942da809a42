"""Flakes in the path tracer."""
