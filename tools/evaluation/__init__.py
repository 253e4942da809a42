"""Comparisons that measure the renderers."""
