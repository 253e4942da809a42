"""Reflectances in the adaptive parameterization of Dupuy & Jakob (2018)."""
