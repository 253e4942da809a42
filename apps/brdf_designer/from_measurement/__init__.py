"""Designs that start from a measurement."""
