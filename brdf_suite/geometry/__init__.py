"""Directions about a surface: frames, angles, half-angle coordinates and Fresnel's equations."""
