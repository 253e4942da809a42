"""Homomorphic factorization of reflectances (McCool, Ang and Ahmad 2001)."""
