"""Measurement of reflectance tables from photographs of a painted sphere (Günther et al. 2005, sections 3 and 4.1)."""
