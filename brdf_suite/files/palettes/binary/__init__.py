"""Palette formats in binary files."""
