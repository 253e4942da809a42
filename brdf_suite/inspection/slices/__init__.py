"""Slices of a reflectance along one or two angles."""
