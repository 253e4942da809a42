"""Factored materials on the GPU."""
