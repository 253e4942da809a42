"""Palette formats in XML."""
