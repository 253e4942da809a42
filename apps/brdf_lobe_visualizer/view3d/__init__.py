"""Lobes in three dimensions."""
