"""Environments whose light is path-traced through procedural geometry: photo studio, street, light tunnel."""
