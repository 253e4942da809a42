"""Reflectances in the path tracer."""
