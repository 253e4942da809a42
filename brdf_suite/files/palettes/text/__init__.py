"""Palette formats in text: CSS, CSV, JSON, lines."""
