"""Widgets that show what a renderer draws with OpenGL."""
