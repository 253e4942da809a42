"""Homomorphic factorization of reflectances (McCool, Ang and Ahmad 2001), and methods for comparison.

Import from the modules: ``factorize`` (samples to a product of maps), ``projections`` (which maps), ``accuracy`` (the
rows of the paper's Table 1), ``separable`` (the singular-value expansion).
"""
