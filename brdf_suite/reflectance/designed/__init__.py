"""Designed paints as reflectances."""
