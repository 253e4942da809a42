"""Palette formats in zip archives."""
