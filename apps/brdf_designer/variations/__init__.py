"""Neighbours of a paint and paints between two."""
