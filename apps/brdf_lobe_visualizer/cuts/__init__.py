"""Slices as curves, polar plots and images."""
