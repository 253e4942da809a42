"""Scattering files of programs that design optics."""
